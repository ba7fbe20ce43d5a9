/* From the scenario to trajectory, attitude and observer. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/file.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"
#include "orbit/sun.h"
#include "orbit/time.h"

static enum um_status build_orientation(struct um_context *context, struct um_model *model)
{
  const struct um_scenario_orientation *from = model->scenario->orbit->earth_orientation;
  model->orientation.ephemeris = model->ephemeris;
  if (from == NULL) {
    /* |UT1-UTC| < 0.9 s turns the Earth by at most 13.5 arcsec, 420 m at the equator */
    um_core_log(context, UM_LOG_INFO,
                "Earth orientation not given, UT1-UTC and pole taken as zero: stations, and tables "
                "in a frame of the Earth, are off by "
                "up to 0.4 km along the parallel (0.06 s of a low orbit) and 20 m by the pole");
    return UM_OK;
  }
  model->orientation.ut1_utc = from->ut1_utc_s;
  model->orientation.xp = from->xp_arcsec * UM_ARCSEC;
  model->orientation.yp = from->yp_arcsec * UM_ARCSEC;
  if (from->finals == NULL) return UM_OK;
  const char *path = NULL;
  UM_TRY(um_model_resolve(context, model, &from->at, from->finals, &path));
  return um_model_blame(context, &from->at, "finals",
                        um_orbit_finals_read(context, path, &model->orientation.finals));
}

#define LATE 1.0 /* an error in time worth a warning [s] */
#define OLD  7.0 /* an age worth one where the error is not known [d] */

/* How old the elements are and what that means, in kilometres and seconds. */
static enum um_status log_tle_age(struct um_context *context, const struct um_model *model,
                                  const struct um_orbit_tle *tle,
                                  const struct um_orbit_trajectory *trajectory, double *error,
                                  double *delay)
{
  static const char *const said[] = {"orbit", "time", NULL};
  double t = model->scenario->time->start, days = (t - tle->epoch_tai) / 86400.0;
  struct um_vec3 v;
  char epoch[32], means[160] = "its error is not known: period of 225 min or more, or near decay";
  UM_TRY(um_orbit_tle_error(context, tle, t, error));
  UM_TRY(um_orbit_trajectory_state(context, trajectory, t, NULL, &v));
  *delay = *error / um_vec3_norm(v);
  um_orbit_time_format(tle->epoch_tai, epoch);
  if (!isnan(*error))
    snprintf(means, sizeof means, "expect %.2g km, %.2g s, along the track (1 sigma)",
             1e-3 * *error, *delay);
  bool late = isnan(*delay) ? fabs(days) > OLD : *delay > LATE;
  bool new = !um_model_origin_says(model, said); /* a variant's origin has warned */
  um_core_log(context, late && new ? UM_LOG_WARNING : UM_LOG_INFO,
              "orbit: elements of object %d, epoch %s, %.1f days %s the first observation: %s",
              tle->catalogue_number, epoch, fabs(days), days >= 0.0 ? "before" : "after", means);
  return UM_OK;
}

static enum um_status trajectory_of_elements(struct um_context *context, struct um_model *model,
                                             const struct um_orbit_elements *elements,
                                             struct um_orbit_trajectory **out)
{
  double error, delay, start = model->scenario->time->start;
  const struct um_orbit_tle *set = &elements->set[um_orbit_elements_nearest(elements, start)];
  UM_TRY(um_orbit_trajectory_create_elements(context, elements, start, &model->orientation, out));
  UM_TRY(log_tle_age(context, model, set, *out, &error, &delay));
  if (out != &model->trajectory) return UM_OK;
  model->orbit_age = start - set->epoch_tai;
  model->orbit_error = error;
  model->orbit_delay = delay;
  return UM_OK;
}

static enum um_status trajectory_of_tle(struct um_context *context, struct um_model *model,
                                        const char *text, struct um_orbit_trajectory **out)
{
  struct um_orbit_tle tle;
  UM_TRY(um_orbit_tle_parse(context, text, 1, &tle));
  const struct um_orbit_elements one = {&tle, 1};
  return trajectory_of_elements(context, model, &one, out);
}

static enum um_status trajectory_of_kepler(struct um_context *context,
                                           const struct um_scenario_kepler *from,
                                           struct um_orbit_trajectory **out)
{
  struct um_orbit_kepler kepler = {.epoch_tai = from->epoch,
                                   .a = from->a_km * 1e3,
                                   .e = from->e,
                                   .i = from->i_deg * UM_DEG,
                                   .raan = from->raan_deg * UM_DEG,
                                   .argp = from->argp_deg * UM_DEG,
                                   .mean_anomaly = from->mean_anomaly_deg * UM_DEG};
  return um_orbit_trajectory_create_kepler(context, &kepler, out);
}

static enum um_status trajectory_of_file(struct um_context *context, struct um_model *model,
                                         const char *name, int object,
                                         struct um_orbit_trajectory **out)
{
  const char *path = NULL;
  struct um_orbit_elements elements;
  UM_TRY(um_model_resolve(context, model, &model->scenario->orbit->at, name, &path));
  UM_TRY(um_orbit_elements_read(context, path, object, &elements));
  enum um_status status = trajectory_of_elements(context, model, &elements, out);
  um_orbit_elements_release(context, &elements);
  return status;
}

/* Key of the orbit that is given. */
static const char *orbit_key(const struct um_scenario_orbit *orbit)
{
  if (orbit->tle != NULL) return "tle";
  if (orbit->tle_file != NULL) return "tle_file";
  if (orbit->elements != NULL) return "elements";
  if (orbit->kepler != NULL) return "kepler";
  if (orbit->circular != NULL) return "circular";
  if (orbit->points != NULL) return "points";
  return orbit->table != NULL ? "table" : "fixed";
}

static enum um_status build_trajectory(struct um_context *context, struct um_model *model)
{
  const struct um_scenario_orbit *orbit = model->scenario->orbit;
  const char *path = NULL;
  if (orbit->tle != NULL) return trajectory_of_tle(context, model, orbit->tle, &model->trajectory);
  if (orbit->tle_file != NULL)
    return trajectory_of_file(context, model, orbit->tle_file, 0, &model->trajectory);
  if (orbit->elements != NULL)
    return trajectory_of_file(context, model, orbit->elements->file, orbit->elements->object,
                              &model->trajectory);
  if (orbit->kepler != NULL)
    return trajectory_of_kepler(context, orbit->kepler, &model->trajectory);
  if (orbit->circular != NULL) {
    const struct um_scenario_circular *c = orbit->circular;
    double epoch = isnan(c->epoch) ? model->scenario->time->start : c->epoch;
    return um_orbit_trajectory_create_circular(
        context, epoch, c->altitude_km * 1e3, model->environment.earth_radius, c->beta_deg * UM_DEG,
        c->period_s, &model->trajectory);
  }
  if (orbit->table != NULL) {
    UM_TRY(um_model_resolve(context, model, &orbit->at, orbit->table, &path));
    return um_orbit_trajectory_create_table(context, path, &model->orientation, &model->trajectory);
  }
  if (orbit->points != NULL) return um_orbit_trajectory_create_none(context, &model->trajectory);
  const double *p = orbit->fixed->position_gcrs_km;
  return um_orbit_trajectory_create_fixed(context, um_vec3(p[0] * 1e3, p[1] * 1e3, p[2] * 1e3),
                                          &model->trajectory);
}

static enum um_status build_observer(struct um_context *context, struct um_model *model)
{
  const struct um_scenario_observer *from = model->scenario->observer;
  struct um_orbit_observer *to = &model->observer;
  if (from == NULL) return UM_OK;
  model->has_observer = true;
  to->light_time = model->scenario->time->light_time;
  to->orientation = model->orientation;
  if (from->station != NULL) {
    um_model_station_place(from->station, to);
    return UM_OK;
  }
  if (from->direction != NULL) {
    to->kind = UM_OBSERVER_DIRECTION;
    to->range = from->direction->range_km * 1e3;
    return um_model_unit(context, &from->direction->at, "unit_gcrs", from->direction->unit_gcrs,
                         &to->direction_gcrs);
  }
  to->kind = UM_OBSERVER_TRAJECTORY;
  const struct um_scenario_moving_observer *moving = from->trajectory;
  if (moving->tle != NULL) {
    UM_TRY(um_model_blame(
        context, &moving->at, "tle",
        trajectory_of_tle(context, model, moving->tle, &model->observer_trajectory)));
  } else {
    const char *path = NULL;
    UM_TRY(um_model_resolve(context, model, &moving->at, moving->table, &path));
    UM_TRY(um_model_blame(context, &moving->at, "table",
                          um_orbit_trajectory_create_table(context, path, &model->orientation,
                                                           &model->observer_trajectory)));
  }
  to->trajectory = model->observer_trajectory;
  return UM_OK;
}

static enum um_status build_pole(struct um_context *context, struct um_model *model)
{
  struct um_mat3 m;
  UM_TRY(
      um_orbit_frames_gcrs_to_itrf(context, &model->orientation, model->scenario->time->start, &m));
  model->pole = um_vec3(m.m[2][0], m.m[2][1], m.m[2][2]);
  model->greenwich = um_vec3(m.m[0][0], m.m[0][1], m.m[0][2]);
  return UM_OK;
}

enum um_status um_model_build_orbit(struct um_context *context, struct um_model *model)
{
  model->orbit_age = model->orbit_error = model->orbit_delay = NAN;
  UM_TRY(build_orientation(context, model));
  UM_TRY(build_pole(context, model));
  UM_TRY(um_model_blame(context, &model->scenario->orbit->at, orbit_key(model->scenario->orbit),
                        build_trajectory(context, model)));
  struct um_effect_use use;
  double shift = 0.0;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.along_track != NULL) shift += use.effect->hooks.along_track(&use);
  um_orbit_trajectory_shift(model->trajectory, shift);
  UM_TRY(um_model_build_attitude(context, model));
  UM_TRY(build_observer(context, model));
  UM_TRY(um_model_build_stations(context, model));
  UM_TRY(um_model_build_points(context, model));
  if (model->sun_frozen)
    model->frozen_sun_position =
        um_orbit_sun_position(model->ephemeris, model->scenario->time->start);
  return um_model_build_slews(context, model);
}
