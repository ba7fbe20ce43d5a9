/* Everything geometric about one timeline, traced once.
 *
 * Observations are instants at the observer (several per exposure); the satellite's own times are
 * earlier by the light time. Heat is computed from whole orbits before the first observation. */
#include "model/geometry/precompute.h"
#include "model/geometry/precompute_group.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/build/effects_group.h"
#include "model/build/messages_group.h"
#include "model/build/timeline.h"
#include "model/geometry/body_tables.h"
#include "model/geometry/bounds_impl.h"
#include "model/geometry/line_of_sight_impl.h"
#include "model/geometry/load_grid_impl.h"
#include "model/geometry/precompute_loads_impl.h"
#include "optics/paths/photon_maps.h"

#define LIGHT_TIMES 0.05 /* by which those of two stations may differ [s] */

const char *um_model_instant_set(const struct um_model_instants *instants, size_t k)
{
  return instants->set != NULL ? instants->set[k] : NULL;
}

enum um_status um_model_tables_keep_sets(struct um_context *context,
                                         const struct um_model_instants *instants,
                                         struct um_model_tables *tables)
{
  if (instants->set == NULL) return UM_OK;
  UM_TRY(um_core_allocate(context, instants->count, sizeof *tables->set, (void *)&tables->set));
  for (size_t k = 0; k < instants->count; k++) tables->set[k] = instants->set[k];
  return UM_OK;
}

size_t um_model_tables_station(const struct um_model_tables *tables, size_t k)
{
  return tables->station != NULL ? tables->station[k] : 0;
}

static enum um_status keep_stations(struct um_context *context,
                                    const struct um_model_instants *instants,
                                    struct um_model_tables *tables)
{
  size_t n = instants->count;
  if (instants->station == NULL) return UM_OK;
  UM_TRY(um_core_allocate(context, n, sizeof *tables->station, &tables->station));
  memcpy(tables->station, instants->station, n * sizeof *tables->station);
  return UM_OK;
}

/* The time at which an observation was really made. */
double um_model_true_time(const struct um_model *model, const char *set, double tag)
{
  struct um_effect_use use;
  double t = tag;
  for (size_t i = 0; um_model_effect_next_in(model, set, &i, &use);)
    if (use.effect->hooks.time != NULL) t = use.effect->hooks.time(&use, t);
  return t;
}

/* The exposure of an observation as it really was [s]. */
static double true_exposure(const struct um_model *model, const struct um_model_instants *instants,
                            size_t k)
{
  struct um_effect_use use;
  const char *set = um_model_instant_set(instants, k);
  double exposure =
      instants->exposure != NULL ? instants->exposure[k] : model->scenario->time->exposure_s;
  for (size_t i = 0; um_model_effect_next_in(model, set, &i, &use);)
    if (use.effect->hooks.exposure != NULL) exposure = use.effect->hooks.exposure(&use, exposure);
  return exposure;
}

enum um_status um_model_scenario_times(struct um_context *context, const struct um_model *model,
                                       double **times, size_t *count)
{
  const struct um_scenario_time *time = model->scenario->time;
  *count = (size_t)floor((time->stop - time->start) / time->step_s + 1e-9) + 1;
  UM_TRY(um_core_allocate(context, *count, sizeof **times, times));
  for (size_t k = 0; k < *count; k++) (*times)[k] = time->start + (double)k * time->step_s;
  return UM_OK;
}

/* Instant i of n in an exposure, in [-1/2, 1/2]: midpoints of equal parts, u_i = (i + 1/2)/n - 1/2,
 * drawn apart by n / sqrt(n^2 - 1), so that their variance is that of the exposure, 1/12, in place
 * of (1 - 1/n^2)/12: with equal weights what is quadratic in time is averaged exactly, and three
 * are Chebyshev's. */
static double instant_of(size_t i, size_t n)
{
  double count = (double)n, u = ((double)i + 0.5) / count - 0.5;
  return n < 2 ? u : u * count / sqrt(count * count - 1.0);
}

/* Light of one instant at two stations left the satellite at two; heat is followed in order, so
 * that the second then has the temperatures of the first. */
static void straighten(struct um_model_tables *tables, size_t k)
{
  size_t i = k * tables->nsub;
  double back = tables->sample[i - 1].t_tai - tables->sample[i].t_tai;
  if (um_model_tables_station(tables, k) != um_model_tables_station(tables, k - 1) && back > 0.0 &&
      back < LIGHT_TIMES)
    tables->sample[i].t_tai += back;
}

static enum um_status trace_observations(struct um_context *context, const struct um_model *model,
                                         const struct um_model_instants *instants,
                                         struct um_model_tables *tables)
{
  const struct um_scenario_time *time = model->scenario->time;
  bool exposed = time->exposure_s > 0.0;
  for (size_t k = 0; k < instants->count; k++)
    exposed = exposed || true_exposure(model, instants, k) > 0.0;
  tables->nobs = instants->count;
  tables->nsub = exposed ? (size_t)time->exposure_samples : 1;
  size_t n = tables->nobs * tables->nsub;
  UM_TRY(um_model_check_instants(context, model, tables->nobs, tables->nsub));
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof(double), &tables->t_obs));
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof(double), &tables->sunlit));
  UM_TRY(um_core_allocate(context, n, sizeof *tables->look, &tables->look));
  UM_TRY(um_core_allocate(context, n, sizeof *tables->sample, &tables->sample));
  memcpy(tables->t_obs, instants->time, tables->nobs * sizeof(double));
  UM_TRY(um_model_tables_keep_sets(context, instants, tables));
  UM_TRY(keep_stations(context, instants, tables));
  um_core_progress_begin(context, "following the orbit", n);
  for (size_t i = 0; i < n; i++) {
    size_t k = i / tables->nsub;
    double u = instant_of(i % tables->nsub, tables->nsub);
    double t = um_model_true_time(model, um_model_instant_set(instants, k),
                                  tables->t_obs[k] + u * true_exposure(model, instants, k));
    if (model->has_observer) {
      UM_TRY(um_model_sample_from(context, model, um_model_tables_station(tables, k), t,
                                  &tables->sample[i], &tables->look[i]));
      if (i > 0 && i % tables->nsub == 0) straighten(tables, k);
    } else {
      UM_TRY(um_model_sample_at(context, model, t, &tables->sample[i]));
      tables->look[i] = (struct um_orbit_look){
          .t_satellite = t, .range = NAN, .azimuth = NAN, .elevation = NAN, .sun_elevation = NAN};
    }
    if (i > 0 && !(tables->sample[i].t_tai >= tables->sample[i - 1].t_tai))
      return um_core_fail(context, UM_ERR_INPUT,
                          "observation %zu: its exposure of %g s begins before the one before it "
                          "ends; accepted: exposures that do not overlap",
                          k + 1, true_exposure(model, instants, k));
    tables->sunlit[k] += tables->sample[i].sunlit_fraction / (double)tables->nsub;
    UM_TRY(um_core_progress_step(context, 1));
  }
  um_core_progress_end(context);
  return UM_OK;
}

/* When the thermal run starts, and the orbit that is made periodic. */
static void trace_span(const struct um_model *model, struct um_model_tables *tables)
{
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  double first = tables->sample[0].t_tai, sum = 0.0;
  /* the middle of an exposure, so that its length does not move the start */
  for (size_t i = 0; i < tables->nsub; i++) sum += tables->sample[i].t_tai - first;
  tables->t_first = first + sum / (double)tables->nsub;
  tables->period = um_orbit_trajectory_period(model->trajectory);
  double orbits = thermal->orbits_before;
  if (thermal->start == UM_START_PERIODIC && orbits < 1.0) orbits = 1.0;
  tables->t_start =
      isnan(tables->period) ? first : fmin(first, tables->t_first - orbits * tables->period);
  /* nothing else asks where the satellite is an orbit after the start: a table may end sooner */
  bool periodic = thermal->start == UM_START_PERIODIC && !isnan(tables->period);
  tables->t_periodic_end = periodic ? tables->t_start + tables->period : tables->t_start;
}

/* Are an instant and the one before it of two sets, or of two stations? */
static bool are_apart(const struct um_model_instants *instants, size_t k)
{
  return um_model_instant_set(instants, k) != um_model_instant_set(instants, k - 1) ||
         (instants->station != NULL && instants->station[k] != instants->station[k - 1]);
}

/* Strictly ascending; of two sets of measurements, or stations, two may be at one time. */
static enum um_status check_times(struct um_context *context,
                                  const struct um_model_instants *instants)
{
  const double *times = instants->time;
  if (instants->count == 0) return um_core_fail(context, UM_ERR_INPUT, "no observation times");
  for (size_t k = 1; k < instants->count; k++)
    if (!(times[k] > times[k - 1]) && !(times[k] == times[k - 1] && are_apart(instants, k)))
      return um_core_fail(context, UM_ERR_INPUT,
                          "observation %zu is not later than the one before it", k + 1);
  return UM_OK;
}

enum um_status um_model_precompute_observed(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_instants *instants,
                                            struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  *out = NULL;
  UM_CHECK(um_model_check_track(context, model));
  UM_CHECK(check_times(context, instants));
  UM_CHECK(um_core_allocate(context, 1, sizeof *tables, &tables));
  UM_CHECK(trace_observations(context, model, instants, tables));
  UM_CHECK(um_model_tables_hide(context, model, tables));
  *out = tables;
  tables = NULL;
done:
  um_model_tables_destroy(context, &tables);
  return status;
}

enum um_status um_model_hidden_at(struct um_context *context, const struct um_model *model,
                                  const double *times, size_t count, bool **hidden)
{
  const struct um_model_instants instants = {.time = times, .count = count};
  struct um_model_tables *tables = NULL;
  *hidden = NULL;
  UM_TRY(um_model_precompute_observed(context, model, &instants, &tables));
  *hidden = tables->hidden;
  tables->hidden = NULL;
  um_model_tables_destroy(context, &tables);
  return UM_OK;
}

static enum um_status plan_at(struct um_context *context, const struct um_model *model,
                              const struct um_model_instants *instants,
                              struct um_model_precompute_plan *out)
{
  struct um_model_tables *tables = NULL;
  UM_TRY(check_times(context, instants));
  UM_TRY(um_core_allocate(context, 1, sizeof *tables, &tables));
  out->tables = tables;
  UM_TRY(trace_observations(context, model, instants, tables));
  UM_TRY(um_model_tables_hide(context, model, tables));
  trace_span(model, tables);
  UM_TRY(um_model_spin_period(context, model, tables, &tables->spin_period));
  tables->sparse = instants->sparse && um_model_load_rows_vary(model, tables);
  double step = um_model_load_step(model, tables);
  double end = tables->sample[tables->nobs * tables->nsub - 1].t_tai;
  UM_TRY(um_model_check_load_rows(context, model, tables,
                                  fmax(end, tables->t_periodic_end) - tables->t_start, step));
  UM_TRY(um_model_events(context, model, tables->t_start, fmax(end, tables->t_periodic_end),
                         &tables->event, &tables->nevent));
  UM_TRY(um_model_load_grid(context, model, tables, step, &out->grid, &out->ngrid));
  return um_model_load_edges(context, model, tables, &out->edge);
}

enum um_status um_model_precompute_plan(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_precompute_plan *out)
{
  struct um_model_instants of = {.count = 0};
  double *window = NULL;
  *out = (struct um_model_precompute_plan){0};
  UM_TRY(um_model_check_track(context, model));
  if (instants != NULL) of = *instants;
  if (of.time == NULL) {
    UM_TRY(um_model_scenario_times(context, model, &window, &of.count));
    of.time = window;
  }
  enum um_status status = plan_at(context, model, &of, out);
  um_core_free(context, window);
  return status;
}

void um_model_precompute_plan_clear(struct um_context *context,
                                    struct um_model_precompute_plan *plan)
{
  um_core_free(context, plan->grid);
  um_core_free(context, plan->edge);
  um_model_tables_destroy(context, &plan->tables);
  *plan = (struct um_model_precompute_plan){0};
}

enum um_status um_model_precompute_view(struct um_context *context, const struct um_model *model,
                                        struct um_model_sampling sampling,
                                        struct um_model_tables *tables)
{
  const struct um_scenario_optics *optics = model->scenario->optics;
  tables->sampling.samples = sampling.samples != 0 ? sampling.samples : optics->samples;
  tables->sampling.paths = optics->interreflection_samples > 0 ? sampling.paths : 0;
  if (!model->has_observer) return UM_OK;
  return um_optics_view_trace(context, model->geometry, tables->sample, tables->nobs * tables->nsub,
                              tables->sampling.samples, (uint64_t)optics->seed, &tables->view);
}

enum um_status um_model_precompute_with(struct um_context *context, const struct um_model *model,
                                        const struct um_model_instants *instants,
                                        struct um_model_body_tables *body,
                                        struct um_model_tables **out)
{
  enum um_status status;
  struct um_model_precompute_plan plan = {0};
  struct um_model_sampling sampling = {0, 0};
  if (instants != NULL) sampling = instants->sampling;
  *out = NULL;
  UM_CHECK(um_model_precompute_plan(context, model, instants, &plan));
  plan.tables->body = um_model_body_tables_share(body);
  UM_CHECK(
      um_model_precompute_loads(context, model, plan.grid, plan.ngrid, plan.edge, plan.tables));
  UM_CHECK(um_model_precompute_view(context, model, sampling, plan.tables));
  *out = plan.tables;
  plan.tables = NULL;
done:
  um_model_precompute_plan_clear(context, &plan);
  return um_model_blame_table(context, model, status);
}

enum um_status um_model_tables_resample(struct um_context *context, const struct um_model *model,
                                        struct um_model_tables *tables,
                                        struct um_model_sampling sampling)
{
  const struct um_scenario_optics *optics = model->scenario->optics;
  struct um_model_tables again = *tables;
  if (tables->view == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "no lines of sight without an observer");
  if (optics->interreflection_samples > 0 && sampling.paths < 1)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%d rays between surfaces; accepted: 1 or more, as the scenario has them",
                        sampling.paths);
  UM_TRY(um_model_precompute_view(context, model, sampling, &again));
  um_optics_photon_maps_destroy(context, &again.photons);
  um_optics_view_destroy(context, &tables->view);
  *tables = again;
  return UM_OK;
}

void um_model_tables_destroy(struct um_context *context, struct um_model_tables **tables)
{
  if (tables == NULL || *tables == NULL) return;
  struct um_model_tables *t = *tables;
  um_core_free(context, t->t_obs);
  um_core_free(context, (void *)t->set);
  um_core_free(context, t->station);
  um_core_free(context, t->sunlit);
  um_core_free(context, t->hidden);
  um_core_free(context, t->look);
  um_core_free(context, t->sample);
  um_core_free(context, t->load_row);
  um_core_free(context, t->load_sample);
  um_core_free(context, t->event);
  if (t->seen != t->loads) um_irradiation_loads_destroy(context, &t->seen);
  um_irradiation_loads_destroy(context, &t->spin_variation);
  um_irradiation_loads_destroy(context, &t->loads);
  um_model_body_tables_release(context, &t->body);
  um_irradiation_mirrored_destroy(context, &t->mirrored);
  um_optics_photon_maps_destroy(context, &t->photons);
  um_optics_view_destroy(context, &t->view);
  um_core_free(context, t);
  *tables = NULL;
}
