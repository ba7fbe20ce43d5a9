/* Evaluations of a scenario with effects added, as values of the observations. */
#include "evidence/sensitivity/forward.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/core/file_snapshot.h"
#include "base/core/suggestions.h"
#include "evidence/comparison/residual.h"
#include "evidence/inversion/refine.h"
#include "evidence/sensitivity/forward_impl.h"
#include "evidence/sensitivity/observations_impl.h"
#include "evidence/sensitivity/policy.h"
#include "model/build/build.h"
#include "model/run/run.h"

void um_sensitivity_forward_null(const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect, const char *target, double *value)
{
  for (size_t p = 0; p < effect->nparameter; p++) value[p] = effect->parameters[p].null_value;
  for (size_t i = 0; i < forward->model->neffect; i++) {
    const struct um_model_effect *e = &forward->model->effect[i];
    if (e->off || e->effect != effect || !um_core_words_same(e->target, target)) continue;
    memcpy(value, e->value, effect->nparameter * sizeof *value);
  }
}

/* --- values ---------------------------------------------------------------------------------- */

static enum um_status predict(struct um_context *context, struct um_sensitivity_forward *forward,
                              const struct um_variant *v)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_variant_observe(context, forward->evaluator, v, &result));
  enum um_status status =
      um_compare_predict(context, forward->plan, v->tables, result, forward->cache->predicted);
  um_model_result_destroy(context, &result);
  return status;
}

#define NEARLY 0.1

void um_sensitivity_forward_correct(const double *few, const double *base, size_t n, double *value)
{
  for (size_t j = 0; j < n; j++) {
    bool nearly = few[j] != 0.0 && fabs(base[j] - few[j]) <= NEARLY * fabs(few[j]);
    value[j] = base[j] + (value[j] - few[j]) * (nearly ? base[j] / few[j] : 1.0);
  }
}

/* Observations in use from the prediction of all, with the tables it is of. */
static enum um_status gather(struct um_context *context,
                             const struct um_sensitivity_forward *forward,
                             const struct um_model_tables *tables, double *value)
{
  const struct um_compare_measurements *m = forward->measurements;
  const struct um_sensitivity_observations *o = &forward->observations;
  um_compare_modelled(m, o->count, o->row, forward->cache->predicted, value);
  for (size_t j = 0; j < o->count; j++) {
    const struct um_compare_channel *channel = &m->channel[o->channel[j]];
    if (!isfinite(value[j]))
      return um_core_fail(context, UM_ERR_INPUT, "%s:%d: the model gives %s '%s' of %g",
                          um_compare_row_path(m, o->row[j]), m->row[o->row[j]].line,
                          um_compare_quantity_name(channel->quantity), channel->of, value[j]);
  }
  if (forward->cache->few != NULL && tables->sampling.paths == forward->paths_before)
    um_sensitivity_forward_correct(forward->cache->few, forward->cache->base, o->count, value);
  return UM_OK;
}

struct um_variant_heat um_sensitivity_forward_heat(const struct um_sensitivity_forward *forward)
{
  return (struct um_variant_heat){.start = UM_VARIANT_WARM, .tolerance = forward->tolerance};
}

/* Heat of a move whose answer is known is extrapolated by it. */
static struct um_variant_heat heat_of(const struct um_sensitivity_forward *forward,
                                      const struct um_sensitivity_move *move)
{
  struct um_variant_heat heat = um_sensitivity_forward_heat(forward);
  const struct um_sensitivity_moved *moved = um_sensitivity_moves_of(forward->cache->moves, move);
  if (moved == NULL) return heat;
  heat.start = UM_VARIANT_EXTRAPOLATED;
  heat.sensitivity = moved->sensitivity;
  heat.light = moved->light;
  heat.which = moved->which;
  heat.step = move->step;
  return heat;
}

/* What heat the last evaluation had. Heat that was kept from another evaluation was integrated,
 * too: what is said of it does not depend on what was evaluated before. */
static void note_heat(struct um_sensitivity_forward *forward, const struct um_variant *v,
                      const struct um_variant_heat *heat)
{
  forward->cache->fresh_heat = v->heat != forward->base.heat;
  forward->cache->moved_heat = v->fresh_heat && heat->start == UM_VARIANT_EXTRAPOLATED;
  if (!v->fresh_heat || heat->start == UM_VARIANT_EXTRAPOLATED) return;
  forward->heat_runs++;
  forward->heat_seconds += v->seconds_heat;
}

static enum um_status evaluate(struct um_context *context, struct um_sensitivity_forward *forward,
                               const struct um_model_addition *addition, size_t naddition,
                               const struct um_sensitivity_move *move, double *value)
{
  enum um_status status;
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  const struct um_variant_heat heat = heat_of(forward, move);
  struct um_variant v = {0};
  UM_CHECK(um_variant_open(context, forward->evaluator, &changes, &heat, &v));
  note_heat(forward, &v, &heat);
  UM_CHECK(predict(context, forward, &v));
  UM_CHECK(gather(context, forward, v.tables, value));
done:
  um_variant_close(context, &v);
  /* the scenario itself was computed, so that what is refused is the additions */
  return status == UM_ERR_INPUT ? UM_ERR_REFUSED : status;
}

static enum um_status evaluate_timed(struct um_context *context,
                                     struct um_sensitivity_forward *forward,
                                     const struct um_model_addition *addition, size_t naddition,
                                     const struct um_sensitivity_move *move, double *value)
{
  double begin = omp_get_wtime();
  enum um_status status = UM_OK;
  if (naddition == 0) {
    forward->cache->fresh_heat = forward->cache->moved_heat = false;
    memcpy(value, forward->cache->base, forward->observations.count * sizeof *value);
  } else {
    um_core_quiet_begin(context);
    status = evaluate(context, forward, addition, naddition, move, value);
    um_core_quiet_end(context);
  }
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

/* One evaluation as a task. */
struct asked {
  struct um_sensitivity_forward *forward;
  const struct um_model_addition *addition;
  size_t naddition;
  double *value;
};

static enum um_status compute_asked(struct um_context *context, void *user, size_t which,
                                    double *value)
{
  const struct asked *a = user;
  (void)which;
  return evaluate_timed(context, a->forward, a->addition, a->naddition, NULL, value);
}

static enum um_status take_asked(struct um_context *context, void *user, size_t which,
                                 enum um_status status, const double *value)
{
  const struct asked *a = user;
  (void)context;
  (void)which;
  if (status == UM_OK) memcpy(a->value, value, a->forward->observations.count * sizeof *a->value);
  return status;
}

enum um_status um_sensitivity_forward_evaluate(struct um_context *context,
                                               struct um_sensitivity_forward *forward,
                                               const struct um_model_addition *addition,
                                               size_t naddition, double *value)
{
  struct asked asked = {forward, addition, naddition, value};
  const struct um_workers_each tasks = {.n = 1,
                                        .nvalue = forward->observations.count,
                                        .compute = compute_asked,
                                        .done = take_asked,
                                        .user = &asked,
                                        .workers = 1};
  if (forward->records == NULL || naddition == 0)
    return evaluate_timed(context, forward, addition, naddition, NULL, value);
  um_core_quiet_begin(context); /* its step is none of the caller's progress */
  enum um_status status = um_sensitivity_forward_tasks(context, forward, &tasks);
  um_core_quiet_end(context);
  return status;
}

enum um_status um_sensitivity_forward_evaluate_move(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_sensitivity_move *move,
                                                    double *value)
{
  struct um_model_addition a = {.effect = move->effect, .target = move->target};
  memcpy(a.value, move->at, move->effect->nparameter * sizeof *a.value);
  a.value[move->parameter] += move->step;
  return evaluate_timed(context, forward, &a, 1, move, value);
}

/* Have heat and light of a variant the shape that those of the scenario have? */
static bool is_like(const struct um_variant *a, const struct um_variant *b)
{
  return um_geometry_mesh(a->model->geometry)->nsurface ==
             um_geometry_mesh(b->model->geometry)->nsurface &&
         um_thermal_network_nodes(a->model->body->network) ==
             um_thermal_network_nodes(b->model->body->network) &&
         a->tables->nobs == b->tables->nobs && a->tables->nsub == b->tables->nsub;
}

enum um_status um_sensitivity_forward_evaluate_turned(struct um_context *context,
                                                      struct um_sensitivity_forward *forward,
                                                      struct um_vec3 turn, double *value)
{
  enum um_status status;
  const struct um_variant *base = &forward->base;
  struct um_model_result *result = NULL;
  double begin = omp_get_wtime();
  um_core_quiet_begin(context);
  UM_CHECK(um_model_run_turned(context, base->model, base->tables, base->heat, turn, &result));
  UM_CHECK(
      um_compare_predict(context, forward->plan, base->tables, result, forward->cache->predicted));
  UM_CHECK(gather(context, forward, base->tables, value));
done:
  um_model_result_destroy(context, &result);
  um_core_quiet_end(context);
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

static enum um_status evaluate_part(struct um_context *context,
                                    struct um_sensitivity_forward *forward,
                                    const struct um_model_addition *addition, bool held,
                                    bool *apart, double *value)
{
  enum um_status status;
  const struct um_model_changes changes = {.addition = addition, .naddition = 1};
  const struct um_variant_heat heat = um_sensitivity_forward_heat(forward);
  struct um_variant v = {0}, mixed = forward->base;
  UM_CHECK(um_variant_open(context, forward->evaluator, &changes, NULL, &v));
  *apart = is_like(&forward->base, &v);
  if (!*apart) goto done;
  if (held) {
    mixed = v;
    mixed.heat = forward->base.heat;
  } else {
    UM_CHECK(um_variant_find_heat(context, forward->evaluator, &heat, &v));
    note_heat(forward, &v, &heat);
    mixed.heat = v.heat;
  }
  UM_CHECK(predict(context, forward, &mixed));
  UM_CHECK(gather(context, forward, mixed.tables, value));
done:
  um_variant_close(context, &v);
  return status == UM_ERR_INPUT ? UM_ERR_REFUSED : status;
}

enum um_status um_sensitivity_forward_evaluate_part(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_model_addition *addition,
                                                    enum um_sensitivity_part part, bool *apart,
                                                    double *value)
{
  double begin = omp_get_wtime();
  *apart = true;
  if (part == UM_SENSITIVITY_WHOLE)
    return um_sensitivity_forward_evaluate(context, forward, addition, 1, value);
  um_core_quiet_begin(context);
  enum um_status status =
      evaluate_part(context, forward, addition, part == UM_SENSITIVITY_HELD, apart, value);
  um_core_quiet_end(context);
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

static enum um_status repeat(struct um_context *context, struct um_sensitivity_forward *forward,
                             double *value)
{
  enum um_status status;
  const struct um_variant_heat heat = um_sensitivity_forward_heat(forward);
  struct um_variant v = forward->base;
  UM_CHECK(um_variant_heat_again(context, forward->evaluator, &heat, &v));
  UM_CHECK(predict(context, forward, &v));
  UM_CHECK(gather(context, forward, v.tables, value));
done:
  um_variant_close(context, &v);
  return status;
}

enum um_status um_sensitivity_forward_noise(struct um_context *context,
                                            struct um_sensitivity_forward *forward, double *out)
{
  enum um_status status = UM_OK;
  double *value = NULL, largest = 0.0, begin = omp_get_wtime();
  const double *base = forward->cache->base;
  *out = forward->cache->noise;
  if (!isnan(*out)) return UM_OK;
  um_core_quiet_begin(context);
  UM_CHECK(um_core_allocate(context, forward->observations.count, sizeof *value, &value));
  UM_CHECK(repeat(context, forward, value));
  for (size_t j = 0; j < forward->observations.count; j++)
    largest = fmax(largest, fabs(value[j] - base[j]) / forward->observations.sigma[j]);
  *out = forward->cache->noise = largest;
done:
  um_core_quiet_end(context);
  um_core_free(context, value);
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

/* --- few paths -------------------------------------------------------------------------------- */

enum um_status um_sensitivity_forward_paths(struct um_context *context,
                                            struct um_sensitivity_forward *forward,
                                            enum um_sensitivity_paths paths)
{
  struct um_sensitivity_forward *f = forward;
  int base = paths == UM_SENSITIVITY_DERIVATIVES ? f->paths : f->paths_before;
  f->instants.sampling.paths = paths == UM_SENSITIVITY_SIGNATURES ? f->paths_before : f->paths;
  if (f->paths == f->paths_before) return UM_OK;
  um_core_quiet_begin(context);
  enum um_status status = um_variant_paths(context, f->evaluator, base, f->instants.sampling.paths);
  um_core_quiet_end(context);
  return status;
}

/* The scenario as it stands by few paths, once. */
static enum um_status find_few(struct um_context *context, struct um_sensitivity_forward *f)
{
  double *few = NULL;
  enum um_status status = UM_OK;
  if (f->paths == f->paths_before) return UM_OK;
  UM_CHECK(um_sensitivity_forward_paths(context, f, UM_SENSITIVITY_VALUES));
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *few, &few));
  UM_CHECK(predict(context, f, &f->base));
  UM_CHECK(gather(context, f, f->base.tables, few));
  f->cache->few = few;
  few = NULL;
done:
  um_core_free(context, few);
  return status;
}

/* --- life ------------------------------------------------------------------------------------ */

/* Is there light among the observations in use? Temperatures have no sampling error. */
static bool has_light(const struct um_sensitivity_forward *f)
{
  const struct um_compare_measurements *m = f->measurements;
  for (size_t i = 0; i < m->count; i++)
    if (f->plan->observation[i] != UM_COMPARE_NOWHERE &&
        m->channel[m->row[i].channel].quantity != UM_QUANTITY_TEMPERATURE)
      return true;
  return false;
}

/* The run of the scenario as it stands, with the samples that all variants will have. */
static enum um_status first_run(struct um_context *context, struct um_sensitivity_forward *f,
                                struct um_model_result **out)
{
  const struct um_variant *base = &f->base;
  struct um_compare_share_user user = {f->model, f->plan};
  struct um_compare_refinement refinement;
  f->samples = f->samples_before = f->model->scenario->optics->samples;
  f->paths = f->paths_before = f->model->scenario->optics->interreflection_samples;
  if (!has_light(f)) return um_model_run_with(context, base->model, base->tables, base->heat, out);
  UM_TRY(um_compare_refine_with(context, f->model, um_variant_base_tables(context, f->evaluator),
                                base->heat, UM_COMPARE_MODEL_SHARE, um_compare_share_of_plan, &user,
                                out, &refinement));
  f->samples = refinement.samples;
  f->paths = refinement.interreflection;
  /* all look at the body with the same points */
  f->instants.sampling = base->tables->sampling;
  return um_variant_paths(context, f->evaluator, f->paths, f->paths);
}

static enum um_status first_evaluation(struct um_context *context, struct um_sensitivity_forward *f)
{
  struct um_sensitivity_forward_cache *cache = f->cache;
  const struct um_variant_settings settings = {.instants = &f->instants,
                                               .base = um_sensitivity_forward_heat(f).tolerance,
                                               .scaled = true,
                                               .photons = true,
                                               .bytes = UM_SENSITIVITY_KEPT};
  struct um_model_result *result = NULL;
  enum um_status status;
  double begin = omp_get_wtime();
  UM_CHECK(um_variant_evaluator_create(context, f->model, &settings, &f->evaluator));
  UM_CHECK(um_variant_base(context, f->evaluator, &f->base));
  UM_CHECK(first_run(context, f, &result));
  UM_CHECK(um_compare_predict(context, f->plan, f->base.tables, result, cache->predicted));
  UM_CHECK(um_sensitivity_observations_create(context, f->plan, f->model->scenario, result,
                                              cache->predicted, &f->observations));
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *cache->base, &cache->base));
  UM_CHECK(gather(context, f, f->base.tables, cache->base));
  UM_CHECK(find_few(context, f));
  f->evaluations = 1;
  f->seconds = f->seconds_first = omp_get_wtime() - begin;
done:
  um_model_result_destroy(context, &result);
  return status;
}

enum um_status um_sensitivity_forward_create(struct um_context *context, const char *path,
                                             const struct um_model_options *options,
                                             const struct um_compare_measurements *measurements,
                                             struct um_variant_tolerance tolerance,
                                             struct um_sensitivity_forward **out)
{
  enum um_status status;
  struct um_sensitivity_forward *f = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(um_core_allocate(context, 1, sizeof *f->cache, &f->cache));
  f->measurements = measurements;
  f->tolerance = tolerance;
  f->cache->noise = NAN;
  if (options != NULL) f->options = *options;
  UM_CHECK(um_core_snapshot_begin(context));
  f->holds_files = true;
  UM_CHECK(um_model_create(context, path, options, &f->model));
  UM_CHECK(um_compare_plan_create(context, f->model, measurements, &f->plan));
  f->instants = um_compare_plan_instants(f->plan);
  UM_CHECK(um_core_allocate(context, measurements->count, sizeof *f->cache->predicted,
                            &f->cache->predicted));
  UM_CHECK(first_evaluation(context, f));
  *out = f;
  f = NULL;
done:
  um_sensitivity_forward_destroy(context, &f);
  return status;
}

void um_sensitivity_forward_destroy(struct um_context *context,
                                    struct um_sensitivity_forward **forward)
{
  if (forward == NULL || *forward == NULL) return;
  struct um_sensitivity_forward *f = *forward;
  if (f->cache != NULL) {
    um_sensitivity_moves_destroy(context, &f->cache->moves);
    um_core_free(context, f->cache->predicted);
    UM_FREE(context, f->cache->base, f->cache->few);
    um_core_free(context, f->cache);
  }
  um_sensitivity_observations_release(context, &f->observations);
  um_variant_evaluator_destroy(context, &f->evaluator);
  um_compare_plan_destroy(context, &f->plan);
  um_model_destroy(context, &f->model);
  if (f->holds_files) um_core_snapshot_end(context);
  um_core_free(context, f);
  *forward = NULL;
}
