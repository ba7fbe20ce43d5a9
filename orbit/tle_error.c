/* How far off the predicted place is, from the age of the elements. Two-line elements carry no
 * covariance; what is known is how SGP4 fares in low orbits:
 *
 *   at the epoch  1 km, an assumption: the round figure in use for low orbits
 *   a day         1 km: held against laser ranging, single sets lose about ten times the 0.1 km a
 *                 day of orbits fitted to several sets (Levit & Marshall 2011, Adv. Space Res.
 *                 47:1107)
 *   drag          15 % of it, what the best of five empirical atmospheres missed 13 sets of
 *                 measured densities by (Hedin 1988, High Altitude Atmospheric Modeling, NASA);
 *                 decays of nine satellites say better than 20 %, sometimes near 10 %, and worse
 *                 above 400 km (Pardini & Anselmo 2000, 51st IAC, Rio de Janeiro). An assumption
 *                 all the same: the error of a set's own B* is no error of an atmosphere alone.
 *                 What is taken is how far SGP4 moves when B* grows by that share; it knows the
 *                 altitude, and grows with the square of time
 *
 *   sigma(t) = hypot(1 km + 1 km/d |t|, |r(1.15 B*) - r(B*)|)
 *
 * A standard deviation, nearly all of it along the track. Sets of one satellite held against each
 * other agree with it within a factor of 2 (tests/orbit/tle_error.c). */
#include <math.h>

#include "orbit/sgp4.h"
#include "orbit/tle.h"

#define AT_EPOCH     1000.0 /* [m] */
#define PER_DAY      1000.0 /* [m] */
#define DRAG_SCATTER 0.15   /* [1] */
#define LOW_ORBIT    225.0  /* longest period of what was measured [min]; beyond it SDP4 begins */
#define TWO_PI       6.283185307179586 /* [rad] */

/* How far the satellite moves when drag grows by its scatter [m]; NaN where it then decays. */
static enum um_status drag_error(struct um_context *context, const struct um_orbit_tle *tle,
                                 double minutes, double *out)
{
  enum um_status status;
  struct um_orbit_sgp4 *as_is = NULL, *more = NULL;
  struct um_orbit_tle draggier = *tle;
  struct um_vec3 r[2], v;
  draggier.bstar *= 1.0 + DRAG_SCATTER;
  *out = NAN;
  UM_CHECK(um_orbit_sgp4_create(context, tle, &as_is));
  UM_CHECK(um_orbit_sgp4_create(context, &draggier, &more));
  if (um_orbit_sgp4_state(context, as_is, minutes, &r[0], &v, NULL) == UM_OK &&
      um_orbit_sgp4_state(context, more, minutes, &r[1], &v, NULL) == UM_OK)
    *out = um_vec3_norm(um_vec3_sub(r[1], r[0]));
  else
    um_core_message_clear(context);
done:
  um_orbit_sgp4_destroy(&as_is);
  um_orbit_sgp4_destroy(&more);
  return status;
}

enum um_status um_orbit_tle_error(struct um_context *context, const struct um_orbit_tle *tle,
                                  double t_tai, double *error)
{
  double days = fabs(t_tai - tle->epoch_tai) / 86400.0, drag;
  *error = NAN;
  if (!(TWO_PI / tle->mean_motion < LOW_ORBIT)) return UM_OK;
  UM_TRY(drag_error(context, tle, (t_tai - tle->epoch_tai) / 60.0, &drag));
  *error = hypot(AT_EPOCH + PER_DAY * days, drag);
  return UM_OK;
}
