/* Observations without a track (orbit.points): every measurement says where the satellite is. What
 * asks for a velocity or for heat that is followed along an orbit is refused; the light of one
 * instant, with Sun, shadow, attitude and the Earth below, is all that such a scenario has. */
#include "model/points.h"
#include "model/points_impl.h"

#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "core/words.h"
#include "model/line_of_sight_impl.h"
#include "model/precompute.h"
#include "model/precompute_impl.h"
#include "model/words_impl.h"

#define ACCEPTED_LAWS                                                                              \
  "fixed, sun, target, yaw_steering, table, magnetic, spin with axis_gcrs or q_gcrs"

static enum um_status check_attitude(struct um_context *context, const struct um_schema_list *laws)
{
  const struct um_scenario_attitude *law = laws->items;
  for (size_t i = 0; i < laws->count; i++) {
    if (law[i].lvlh != NULL)
      return um_model_fail(context, &law[i].at, "lvlh",
                           "wants a velocity, which orbit.points does not know; "
                           "accepted: " ACCEPTED_LAWS);
    if (law[i].spin != NULL && law[i].spin->axis_lvlh.count > 0)
      return um_model_fail(context, &law[i].spin->at, "axis_lvlh",
                           "wants a velocity, which orbit.points does not know; "
                           "accepted: " ACCEPTED_LAWS);
  }
  return UM_OK;
}

static enum um_status add_station(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_station *from)
{
  const char *own = model->scenario->observer->station->name;
  const struct um_scenario_station *other = model->scenario->orbit->points->stations.items;
  if (from->name == NULL)
    return um_model_fail(context, &from->at, NULL, "has no name; accepted: the one that rows use");
  bool taken = own != NULL && strcmp(from->name, own) == 0;
  for (; other != from; other++) taken = taken || strcmp(from->name, other->name) == 0;
  if (taken)
    return um_model_fail(context, &from->at, "name", "'%s' is taken; accepted: names used once",
                         from->name);
  struct um_orbit_observer *to = &model->station[model->nstation++];
  *to = model->observer;
  to->latitude = from->latitude_deg * UM_DEG;
  to->longitude = from->longitude_deg * UM_DEG;
  to->height = from->height_m;
  return UM_OK;
}

enum um_status um_model_build_points(struct um_context *context, struct um_model *model)
{
  const struct um_scenario *scenario = model->scenario;
  const struct um_scenario_points *points = scenario->orbit->points;
  if (points == NULL) return UM_OK;
  model->points = true;
  if (!model->has_observer || model->observer.kind != UM_OBSERVER_STATION)
    return um_model_fail(context, &scenario->orbit->at, "points",
                         "wants the station that azimuths and elevations are of; accepted: "
                         "observer.station");
  if (scenario->thermal->start != UM_START_ISOTHERMAL)
    return um_model_fail(context, &scenario->thermal->at, "start",
                         "periodic wants an orbit, orbit.points has none; accepted: isothermal "
                         "(temperatures stay at start_temperature_K)");
  UM_TRY(check_attitude(context, &scenario->attitude));
  const struct um_scenario_station *station = points->stations.items;
  UM_TRY(um_core_allocate(context, points->stations.count + 1, sizeof *model->station,
                          &model->station));
  model->station[model->nstation++] = model->observer;
  for (size_t i = 0; i < points->stations.count; i++)
    UM_TRY(add_station(context, model, &station[i]));
  um_core_log(context, UM_LOG_INFO,
              "orbit: observations stand alone; heat is not followed, temperatures stay at "
              "thermal.start_temperature_K, %g K",
              scenario->thermal->start_temperature_K);
  return UM_OK;
}

enum um_status um_model_station_find(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out)
{
  const char *own = model->scenario->observer->station->name;
  const struct um_scenario_points *points = model->scenario->orbit->points;
  const struct um_scenario_station *other = points->stations.items;
  char names[320] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  *out = 0;
  if (name[0] == '\0' || (own != NULL && strcmp(name, own) == 0)) return UM_OK;
  if (own != NULL) um_core_words_append(names, sizeof names, own);
  if (own != NULL) um_core_words_consider(&guess, own);
  for (size_t i = 0; i < points->stations.count; i++) {
    *out = i + 1;
    if (strcmp(name, other[i].name) == 0) return UM_OK;
    um_core_words_append(names, sizeof names, other[i].name);
    um_core_words_consider(&guess, other[i].name);
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "the scenario has no station '%.60s'%s; accepted: %s%sempty for the "
                      "observer's (observer.station, orbit.points.stations)",
                      name, um_core_words_hint(&guess, hint), names, names[0] == '\0' ? "" : ", ");
}

/* --- geometry precomputation
 * ----------------------------------------------------------------------------------- */

static enum um_status check_points(struct um_context *context, const struct um_model *model,
                                   const struct um_model_point *points, size_t n)
{
  if (!model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: the scenario has an orbit; accepted: orbit.points for observations "
                        "that stand alone",
                        model->scenario->at.file);
  if (n == 0) return um_core_fail(context, UM_ERR_INPUT, "no observations");
  for (size_t k = 1; k < n; k++)
    if (!(points[k].t >= points[k - 1].t))
      return um_core_fail(context, UM_ERR_INPUT,
                          "observation %zu is earlier than the one before it", k + 1);
  return UM_OK;
}

static enum um_status trace_points(struct um_context *context, const struct um_model *model,
                                   const struct um_model_point *points,
                                   struct um_model_precomputed *precomputed)
{
  size_t n = precomputed->nobs;
  UM_TRY(um_core_allocate(context, n, sizeof(double), &precomputed->t_obs));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &precomputed->sunlit));
  UM_TRY(um_core_allocate(context, n, sizeof *precomputed->look, &precomputed->look));
  UM_TRY(um_core_allocate(context, n, sizeof *precomputed->sample, &precomputed->sample));
  UM_TRY(um_core_allocate(context, n, sizeof *precomputed->load_row, &precomputed->load_row));
  for (size_t k = 0; k < n; k++) {
    struct um_model_point point = points[k];
    point.t = um_model_true_time(model, point.t);
    UM_TRY(um_model_sample_point(context, model, &point, &precomputed->sample[k],
                                 &precomputed->look[k]));
    precomputed->t_obs[k] = points[k].t;
    precomputed->sunlit[k] = precomputed->sample[k].sunlit_fraction;
    precomputed->load_row[k] = k;
  }
  precomputed->t_first = precomputed->t_start = precomputed->t_periodic_end =
      precomputed->sample[0].t_tai;
  return UM_OK;
}

/* One row for each point; rows want times that ascend, which points have not. */
static enum um_status trace_loads(struct um_context *context, const struct um_model *model,
                                  struct um_model_precomputed *precomputed)
{
  struct um_environment_sample *numbered = NULL;
  UM_TRY(um_core_allocate(context, precomputed->nobs, sizeof *numbered, &numbered));
  for (size_t k = 0; k < precomputed->nobs; k++) {
    numbered[k] = precomputed->sample[k];
    numbered[k].t_tai = precomputed->t_start + (double)k;
  }
  struct um_environment environment = model->environment;
  environment.absorptance_by_angle = false; /* heat is not followed */
  enum um_status status = um_irradiation_loads_trace(
      context, model->geometry, &environment, numbered, precomputed->nobs, NULL, 0,
      model->scenario->thermal->samples, &precomputed->loads);
  precomputed->seen = precomputed->loads;
  um_core_free(context, numbered);
  return status;
}

enum um_status um_model_points_plan(struct um_context *context, const struct um_model *model,
                                    const struct um_model_instants *instants,
                                    struct um_model_precomputed **out)
{
  enum um_status status;
  struct um_model_precomputed *precomputed = NULL;
  *out = NULL;
  UM_TRY(check_points(context, model, instants->point, instants->count));
  UM_TRY(um_core_allocate(context, 1, sizeof *precomputed, &precomputed));
  *precomputed = (struct um_model_precomputed){
      .nobs = instants->count, .nsub = 1, .points = true, .period = NAN};
  UM_CHECK(trace_points(context, model, instants->point, precomputed));
  UM_CHECK(um_model_precomputed_hide(context, model, precomputed));
done:
  if (status != UM_OK) um_model_precomputed_destroy(context, &precomputed);
  *out = precomputed;
  return status;
}

enum um_status um_model_precompute_points(struct um_context *context, const struct um_model *model,
                                          const struct um_model_point *points, size_t npoint,
                                          struct um_model_sampling sampling,
                                          struct um_model_precomputed **out)
{
  enum um_status status;
  const struct um_model_instants instants = {.point = points, .count = npoint};
  struct um_model_precomputed *precomputed = NULL;
  *out = NULL;
  UM_CHECK(um_model_points_plan(context, model, &instants, &precomputed));
  UM_CHECK(trace_loads(context, model, precomputed));
  UM_CHECK(um_model_precompute_view(context, model, sampling, precomputed));
done:
  status = um_model_blame_table(context, model, status);
  if (status != UM_OK) um_model_precomputed_destroy(context, &precomputed);
  *out = precomputed;
  return status;
}
