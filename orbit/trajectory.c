/* One object behind every kind of orbit: how each is made, and the choice between kinds. */
#include "orbit/trajectory.h"

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "orbit/sgp4_impl.h"
#include "orbit/sun.h"
#include "orbit/trajectory_impl.h"

static enum um_status allocate(struct um_context *context, enum trajectory_kind kind,
                               struct um_orbit_trajectory **out)
{
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->context = context;
  (*out)->kind = kind;
  (*out)->period = NAN;
  (*out)->epoch = NAN;
  return UM_OK;
}

void um_orbit_trajectory_destroy(struct um_orbit_trajectory **trajectory)
{
  if (!trajectory || !*trajectory) return;
  struct um_context *context = (*trajectory)->context;
  for (size_t i = 0; i < (*trajectory)->nset; i++) um_orbit_sgp4_destroy(&(*trajectory)->sgp4[i]);
  UM_FREE(context, (*trajectory)->sgp4, (*trajectory)->epochs);
  um_orbit_table_clear(context, &(*trajectory)->table);
  um_core_free(context, *trajectory);
  *trajectory = NULL;
}

enum um_status um_orbit_trajectory_create_tle(struct um_context *context,
                                              const struct um_orbit_tle *tle,
                                              const struct um_orbit_earth_orientation *orientation,
                                              struct um_orbit_trajectory **out)
{
  struct um_orbit_tle set = *tle;
  const struct um_orbit_elements one = {&set, 1};
  return um_orbit_trajectory_create_elements(context, &one, tle->epoch_tai, orientation, out);
}

enum um_status um_orbit_trajectory_create_elements(
    struct um_context *context, const struct um_orbit_elements *elements, double t_near,
    const struct um_orbit_earth_orientation *orientation, struct um_orbit_trajectory **out)
{
  enum um_status status;
  size_t nearest = um_orbit_elements_nearest(elements, t_near);
  UM_TRY(allocate(context, TRAJECTORY_TLE, out));
  struct um_orbit_trajectory *to = *out;
  to->orientation = *orientation;
  UM_CHECK(um_core_allocate(context, elements->count, sizeof(void *), &to->sgp4));
  UM_CHECK(um_core_allocate(context, elements->count, sizeof *to->epochs, &to->epochs));
  for (; to->nset < elements->count; to->nset++) {
    to->epochs[to->nset] = elements->set[to->nset].epoch_tai;
    UM_CHECK(um_orbit_sgp4_create(context, &elements->set[to->nset], &to->sgp4[to->nset]));
  }
  to->epoch = to->epochs[nearest];
  to->period = um_orbit_sgp4_nodal_period(to->sgp4[nearest]);
done:
  if (status != UM_OK) um_orbit_trajectory_destroy(out);
  return status;
}

enum um_status um_orbit_trajectory_create_fixed(struct um_context *context, struct um_vec3 r_gcrs,
                                                struct um_orbit_trajectory **out)
{
  *out = NULL;
  double radius = um_vec3_norm(r_gcrs);
  if (!(radius > 0.0 && radius < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "fixed position (%g, %g, %g) m; finite numbers, not all zero, are accepted",
                        r_gcrs.x, r_gcrs.y, r_gcrs.z);
  UM_TRY(allocate(context, TRAJECTORY_FIXED, out));
  (*out)->fixed = r_gcrs;
  return UM_OK;
}

enum um_status um_orbit_trajectory_create_none(struct um_context *context,
                                               struct um_orbit_trajectory **out)
{
  return allocate(context, TRAJECTORY_NONE, out);
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
  UM_TRY(allocate(context, TRAJECTORY_KEPLER, out));
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
  UM_TRY(allocate(context, TRAJECTORY_CIRCULAR, out));
  double radius = earth_radius + altitude;
  struct um_vec3 s = um_vec3_unit(um_orbit_sun_position(NULL, epoch_tai));
  struct um_vec3 m = um_vec3_unit(um_vec3_axpy(um_vec3(0.0, 0.0, 1.0), -s.z, s));
  struct um_vec3 h = um_vec3_axpy(um_vec3_scale(s, sin(beta)), cos(beta), m);
  struct um_vec3 u = um_vec3_axpy(um_vec3_scale(s, cos(beta)), -sin(beta), m);
  double rate = period > 0.0 ? 2.0 * UM_PI / period : sqrt(UM_EARTH_GM / radius) / radius;
  (*out)->conic = (struct um_orbit_conic){
      .p = u, .q = um_vec3_cross(h, u), .a = radius, .rate = rate, .epoch = epoch_tai};
  (*out)->period = 2.0 * UM_PI / rate;
  return UM_OK;
}

enum um_status
um_orbit_trajectory_create_table(struct um_context *context, const char *path,
                                 const struct um_orbit_earth_orientation *orientation,
                                 struct um_orbit_trajectory **out)
{
  enum um_status status;
  UM_TRY(allocate(context, TRAJECTORY_TABLE, out));
  UM_CHECK(um_orbit_table_read(context, path, orientation, &(*out)->table));
  (*out)->period = um_orbit_table_period(&(*out)->table);
done:
  if (status != UM_OK) um_orbit_trajectory_destroy(out);
  return status;
}

/* The set whose epoch is nearest. */
static size_t nearest_set(const struct um_orbit_trajectory *orbit, double t_tai)
{
  if (orbit->nset < 2) return 0;
  size_t k = um_core_interval_find(orbit->epochs, orbit->nset, t_tai);
  return t_tai - orbit->epochs[k] > orbit->epochs[k + 1] - t_tai ? k + 1 : k;
}

/* SGP4 at (t - epoch) in minutes, TEME rotated to GCRS. */
static enum um_status tle_state(struct um_context *context, const struct um_orbit_trajectory *orbit,
                                double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  struct um_vec3 r_teme, v_teme;
  struct um_mat3 rotation;
  size_t set = nearest_set(orbit, t_tai);
  double minutes = (t_tai - orbit->epochs[set]) / 60.0;
  UM_TRY(um_orbit_sgp4_state(context, orbit->sgp4[set], minutes, &r_teme, &v_teme, NULL));
  UM_TRY(um_orbit_frames_teme_to_gcrs(context, &orbit->orientation, t_tai, &rotation));
  *r = um_mat3_apply(rotation, r_teme);
  *v = um_mat3_apply(rotation, v_teme);
  return UM_OK;
}

static enum um_status state_of(struct um_context *context, const struct um_orbit_trajectory *orbit,
                               double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  switch (orbit->kind) {
  case TRAJECTORY_TLE:
    return tle_state(context, orbit, t_tai, r, v);
  case TRAJECTORY_TABLE:
    return um_orbit_table_state(context, &orbit->table, t_tai, r, v);
  case TRAJECTORY_FIXED:
    *r = orbit->fixed;
    *v = um_vec3(0.0, 0.0, 0.0);
    return UM_OK;
  case TRAJECTORY_NONE:
    return um_core_fail(context, UM_ERR_INPUT,
                        "the observations stand alone (orbit.points), between them nothing is "
                        "known; accepted: an orbit, or measurements with satellite_height_km, "
                        "azimuth_deg and elevation_deg (umbra compare, diagnose, fit)");
  case TRAJECTORY_KEPLER:
  case TRAJECTORY_CIRCULAR:
    break;
  }
  return um_orbit_conic_state(context, &orbit->conic, t_tai, r, v);
}

enum um_status um_orbit_trajectory_state(struct um_context *context,
                                         const struct um_orbit_trajectory *trajectory, double t_tai,
                                         struct um_vec3 *r_gcrs, struct um_vec3 *v_gcrs)
{
  struct um_vec3 r, v;
  if (!isfinite(t_tai))
    return um_core_fail(context, UM_ERR_INPUT, "trajectory: the time is not a finite number");
  UM_TRY(state_of(context, trajectory, t_tai + trajectory->shift, &r, &v));
  if (r_gcrs) *r_gcrs = r;
  if (v_gcrs) *v_gcrs = v;
  return UM_OK;
}

void um_orbit_trajectory_shift(struct um_orbit_trajectory *trajectory, double seconds)
{
  trajectory->shift = seconds;
}

double um_orbit_trajectory_period(const struct um_orbit_trajectory *trajectory)
{
  return trajectory->period;
}

void um_orbit_trajectory_span(const struct um_orbit_trajectory *trajectory, double *first,
                              double *last)
{
  bool table = trajectory->kind == TRAJECTORY_TABLE;
  *first = table ? trajectory->table.t[0] : -INFINITY;
  *last = table ? trajectory->table.t[trajectory->table.n - 1] : INFINITY;
}

double um_orbit_trajectory_epoch(const struct um_orbit_trajectory *trajectory)
{
  return trajectory->epoch;
}
