/* Two-body motion: Kepler elements in GCRS, and the circular orbit of given altitude and beta.
 *
 *   M = M0 + n (t - t0),  M = E - e sin E
 *   r = a (cos E - e) P + b sin E Q,  v = dE/dt (-a sin E P + b cos E Q),  dE/dt = n / (1 - e cos
 * E) Reference: Vallado 2013, Fundamentals of Astrodynamics, chapters 2 and 5; Montenbruck & Gill
 * 2000, chapter 2. */
#include "core/constants.h"
#include "orbit/sun.h"
#include "orbit/trajectory_impl.h"

enum { KEPLER_ITERATIONS = 100 };

static enum um_status not_converged(struct um_context *context, double mean_anomaly, double e)
{
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "Kepler's equation did not converge: mean anomaly %.17g rad, eccentricity %g",
                      mean_anomaly, e);
}

/* Newton inside the bracket [M - e, M + e], bisection whenever a step would leave it. */
enum um_status um_orbit_kepler_solve(struct um_context *context, double mean_anomaly, double e,
                                     double *eccentric_anomaly)
{
  double turns = nearbyint(mean_anomaly / (2.0 * UM_PI)) * 2.0 * UM_PI;
  double m = mean_anomaly - turns; /* [-pi, pi] */
  double low = m - e, high = m + e, x = m + 0.85 * e * (m < 0.0 ? -1.0 : 1.0);
  for (int k = 0; k < KEPLER_ITERATIONS; k++) {
    double f = x - e * sin(x) - m;
    if (f > 0.0)
      high = x;
    else
      low = x;
    double newton = x - f / (1.0 - e * cos(x));
    /* a step, or a residual, of the size of the rounding */
    if (fabs(newton - x) <= 4e-16 * (1.0 + fabs(x)) || fabs(f) <= 4e-16 * fabs(x)) {
      *eccentric_anomaly = newton + turns;
      return UM_OK;
    }
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (!(x > low && x < high)) { /* the bracket is down to neighbouring numbers */
      *eccentric_anomaly = x + turns;
      return isfinite(x) ? UM_OK : not_converged(context, mean_anomaly, e);
    }
  }
  return not_converged(context, mean_anomaly, e);
}

enum um_status um_orbit_conic_state(struct um_context *context, const struct um_orbit_conic *conic,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  double e = conic->e, anomaly;
  double m = conic->m0 + conic->rate * (t_tai - conic->epoch);
  UM_TRY(um_orbit_kepler_solve(context, m, e, &anomaly));
  double c = cos(anomaly), s = sin(anomaly), b = conic->a * sqrt((1.0 - e) * (1.0 + e));
  double anomaly_rate = conic->rate / (1.0 - e * c);
  *r = um_vec3_axpy(um_vec3_scale(conic->p, conic->a * (c - e)), b * s, conic->q);
  *v = um_vec3_axpy(um_vec3_scale(conic->p, -anomaly_rate * conic->a * s), anomaly_rate * b * c,
                    conic->q);
  return UM_OK;
}

enum um_status um_orbit_trajectory_create_kepler(struct um_context *context,
                                                 const struct um_orbit_kepler *k,
                                                 struct um_orbit_trajectory **out)
{
  *out = NULL;
  const double polar = UM_EARTH_RADIUS * (1.0 - UM_EARTH_FLATTENING); /* [m] */
  if (!(k->e >= 0.0 && k->e < 1.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "Kepler elements: eccentricity %g, 0 to below 1 is accepted", k->e);
  if (!(k->a * (1.0 - k->e) > polar && k->a < INFINITY))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "Kepler elements: perigee radius %.3f km (a %.3f km, e %g), above the Earth's "
        "%.3f km is accepted",
        1e-3 * k->a * (1.0 - k->e), 1e-3 * k->a, k->e, 1e-3 * polar);
  if (!isfinite(k->i + k->raan + k->argp + k->mean_anomaly + k->epoch_tai))
    return um_core_fail(context, UM_ERR_INPUT,
                        "Kepler elements: angles and epoch must be finite numbers");
  UM_TRY(um_orbit_trajectory_allocate(context, TRAJECTORY_KEPLER, out));
  /* P and Q: R3(-raan) R1(-i) R3(-argp) applied to x and y */
  double cn = cos(k->raan), sn = sin(k->raan), ci = cos(k->i), si = sin(k->i);
  double cw = cos(k->argp), sw = sin(k->argp);
  double rate = sqrt(UM_EARTH_GM / k->a) / k->a; /* n = sqrt(mu / a^3) */
  (*out)->conic = (struct um_orbit_conic){
      .p = um_vec3(cn * cw - sn * sw * ci, sn * cw + cn * sw * ci, sw * si),
      .q = um_vec3(-cn * sw - sn * cw * ci, -sn * sw + cn * cw * ci, cw * si),
      .a = k->a,
      .e = k->e,
      .rate = rate,
      .m0 = k->mean_anomaly,
      .epoch = k->epoch_tai};
  (*out)->period = 2.0 * UM_PI / rate;
  return UM_OK;
}

/* With the unit vector s to the Sun and m, the pole's part across s:
 *   normal   h = sin(beta) s + cos(beta) m    (h . s = sin beta, nearest the pole)
 *   epoch    u = cos(beta) s - sin(beta) m    (in the plane, nearest s),  ahead  h x u */
enum um_status um_orbit_trajectory_create_circular(struct um_context *context, double epoch_tai,
                                                   double altitude, double earth_radius,
                                                   double beta, double period,
                                                   struct um_orbit_trajectory **out)
{
  *out = NULL;
  if (!(altitude > 0.0 && altitude < INFINITY && earth_radius > 0.0 && earth_radius < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "circular orbit: altitude %g km above a radius of %g km; positive numbers "
                        "are accepted",
                        1e-3 * altitude, 1e-3 * earth_radius);
  if (!(fabs(beta) <= 0.5 * UM_PI + 1e-12))
    return um_core_fail(context, UM_ERR_INPUT,
                        "circular orbit: beta %g deg, -90 to 90 deg is accepted", beta / UM_DEG);
  if (!(period >= 0.0 && period < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "circular orbit: period %g s, a positive number (or 0 for Kepler's) is "
                        "accepted",
                        period);
  if (!isfinite(epoch_tai))
    return um_core_fail(context, UM_ERR_INPUT, "circular orbit: the epoch is not a finite number");
  UM_TRY(um_orbit_trajectory_allocate(context, TRAJECTORY_CIRCULAR, out));
  double radius = earth_radius + altitude;
  struct um_vec3 s = um_vec3_unit(um_orbit_sun_position(epoch_tai));
  struct um_vec3 m = um_vec3_unit(um_vec3_axpy(um_vec3(0.0, 0.0, 1.0), -s.z, s));
  struct um_vec3 h = um_vec3_axpy(um_vec3_scale(s, sin(beta)), cos(beta), m);
  struct um_vec3 u = um_vec3_axpy(um_vec3_scale(s, cos(beta)), -sin(beta), m);
  double rate = period > 0.0 ? 2.0 * UM_PI / period : sqrt(UM_EARTH_GM / radius) / radius;
  (*out)->conic = (struct um_orbit_conic){
      .p = u, .q = um_vec3_cross(h, u), .a = radius, .rate = rate, .epoch = epoch_tai};
  (*out)->period = 2.0 * UM_PI / rate;
  return UM_OK;
}
