/* What of geometry tables the observer can see at all.
 *
 * A station sees above its horizon, as refraction lifts what it sees (airless elevation -0.55 deg:
 * there airmass ends). Who moves, or looks
 * from a direction at a range, sees where the Earth's ellipsoid does not stand between. A row with
 * one such instant in its exposure is hidden: nothing arrives, and nothing is predicted for it but
 * the radiant intensity, which belongs to the satellite. */
#include "model/geometry/line_of_sight_impl.h"

#include <math.h>

#include "environment/airmass.h"
#include "model/scenario/fail_group.h"
#include "orbit/time.h"

/* Farthest corner of the body from its origin, joints as they stand [m]. */
static enum um_status body_reach(struct um_context *context, const struct um_model *model,
                                 const struct um_environment_sample *sample, double *out)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL;
  UM_CHECK(
      um_core_allocate(context, um_geometry_joint_count(model->geometry), sizeof *angles, &angles));
  um_geometry_joint_angles(model->geometry, um_quat_apply(sample->q, sample->sun), sample->t_tai,
                           angles);
  UM_CHECK(um_geometry_pose_create(context, model->geometry, angles, &pose));
  *out = 0.0;
  for (size_t i = 0; i < mesh->nvertex; i++) *out = fmax(*out, um_vec3_norm(pose->vertex[i]));
done:
  um_geometry_pose_destroy(context, &pose);
  um_core_free(context, angles);
  return status;
}

/* Light is followed to an observer far away; one between the parts has no far away. */
static enum um_status check_range(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables)
{
  const struct um_scenario_observer *observer = model->scenario->observer;
  size_t nearest = 0, n = tables->nobs * tables->nsub;
  double reach;
  for (size_t i = 1; i < n; i++)
    if (tables->sample[i].range < tables->sample[nearest].range) nearest = i;
  double range = tables->sample[nearest].range;
  UM_TRY(body_reach(context, model, &tables->sample[nearest], &reach));
  if (range > reach) return UM_OK;
  if (observer->direction != NULL)
    return um_model_fail(
        context, &observer->direction->at, "range_km",
        "%g (%g m) puts the observer inside the satellite, which reaches %g m from "
        "its origin; accepted: more than that",
        observer->direction->range_km, range, reach);
  char time[32];
  um_orbit_time_format(tables->t_obs[nearest / tables->nsub], time);
  return um_model_fail(context, &observer->at, NULL,
                       "at %s it stands %g m from the satellite, which reaches %g m from its "
                       "origin; accepted: an observer outside it",
                       time, range, reach);
}

static bool instant_is_hidden(const struct um_model *model, const struct um_model_tables *tables,
                              size_t i)
{
  const struct um_environment_sample *s = &tables->sample[i];
  if (model->observer.kind == UM_OBSERVER_STATION)
    return isnan(um_environment_airmass_toward(tables->look[i].elevation));
  return um_environment_earth_between(s->r, s->to_observer, s->range, s->pole);
}

static void log_hidden(struct um_context *context, const struct um_model *model,
                       const struct um_model_tables *tables, size_t count)
{
  bool station = model->observer.kind == UM_OBSERVER_STATION;
  char first[32], last[32];
  size_t a = 0, b = tables->nobs - 1;
  if (count == 0) return;
  while (!tables->hidden[a]) a++;
  while (!tables->hidden[b]) b--;
  um_orbit_time_format(tables->t_obs[a], first);
  um_orbit_time_format(tables->t_obs[b], last);
  um_core_log(context, UM_LOG_INFO,
              "%s in %zu of %zu observations (first %s, last %s): irradiance, counts and "
              "magnitudes of these are left empty, radiant intensity is given",
              station ? "the satellite is below the horizon"
                      : "the Earth stands between satellite and observer",
              count, tables->nobs, first, last);
}

enum um_status um_model_tables_hide(struct um_context *context, const struct um_model *model,
                                    struct um_model_tables *tables)
{
  size_t count = 0;
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof *tables->hidden, &tables->hidden));
  if (!model->has_observer) return UM_OK;
  UM_TRY(check_range(context, model, tables));
  for (size_t k = 0; k < tables->nobs; k++) {
    for (size_t i = k * tables->nsub; i < (k + 1) * tables->nsub; i++)
      tables->hidden[k] = tables->hidden[k] || instant_is_hidden(model, tables, i);
    count += tables->hidden[k];
  }
  log_hidden(context, model, tables, count);
  return UM_OK;
}
