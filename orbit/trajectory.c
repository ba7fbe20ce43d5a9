/* One object behind every kind of orbit; here TLE and fixed point, and the choice between kinds. */
#include "orbit/trajectory.h"

#include "core/constants.h"
#include "orbit/sgp4_impl.h"
#include "orbit/trajectory_impl.h"

enum um_status um_orbit_trajectory_allocate(struct um_context *context, enum trajectory_kind kind,
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
  um_orbit_sgp4_destroy(&(*trajectory)->sgp4);
  um_orbit_table_clear(context, &(*trajectory)->table);
  um_core_free(context, *trajectory);
  *trajectory = NULL;
}

enum um_status um_orbit_trajectory_create_tle(struct um_context *context,
                                              const struct um_orbit_tle *tle,
                                              const struct um_orbit_earth_orientation *orientation,
                                              struct um_orbit_trajectory **out)
{
  enum um_status status;
  UM_TRY(um_orbit_trajectory_allocate(context, TRAJECTORY_TLE, out));
  (*out)->orientation = *orientation;
  (*out)->epoch = tle->epoch_tai;
  UM_CHECK(um_orbit_sgp4_create(context, tle, &(*out)->sgp4));
  (*out)->period = um_orbit_sgp4_nodal_period((*out)->sgp4);
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
  UM_TRY(um_orbit_trajectory_allocate(context, TRAJECTORY_FIXED, out));
  (*out)->fixed = r_gcrs;
  return UM_OK;
}

enum um_status um_orbit_trajectory_create_none(struct um_context *context,
                                               struct um_orbit_trajectory **out)
{
  return um_orbit_trajectory_allocate(context, TRAJECTORY_NONE, out);
}

/* SGP4 at (t - epoch) in minutes, TEME rotated to GCRS. */
static enum um_status tle_state(struct um_context *context, const struct um_orbit_trajectory *orbit,
                                double t_tai, struct um_vec3 *r, struct um_vec3 *v)
{
  struct um_vec3 r_teme, v_teme;
  struct um_mat3 rotation;
  double minutes = (t_tai - orbit->epoch) / 60.0;
  UM_TRY(um_orbit_sgp4_state(context, orbit->sgp4, minutes, &r_teme, &v_teme, NULL));
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
