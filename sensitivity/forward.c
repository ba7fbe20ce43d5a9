/* Evaluations of a scenario with effects added. Heat of a variant starts from the scenario's own
 * periodic state, never from the variant before, so that a value does not depend on what was
 * computed earlier. */
#include "sensitivity/forward.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "compare/refine.h"
#include "compare/residual.h"
#include "core/held_files.h"
#include "core/words.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "model/thermal_solution.h"
#include "sensitivity/forward_impl.h"
#include "sensitivity/observations_impl.h"
#include "sensitivity/variant_impl.h"

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

/* --- a variant with its geometry precomputation and heat
 * ------------------------------------------------------- */

/* What a variant is computed with; what is owned here is released after the evaluation. */
struct variant {
  struct um_model *model; /* owned, until it is kept with a geometry precomputation */
  const struct um_model *used;
  const struct um_model_precomputed *precomputed;
  const struct um_model_thermal_solution *heat;
  struct um_model_thermal_solution *own_heat;
};

static void variant_release(struct um_context *context, struct variant *v)
{
  um_model_thermal_solution_destroy(context, &v->own_heat);
  um_model_destroy(context, &v->model);
}

/* The kept geometry precomputation of this key, made when there is none; it takes key and model of
 * the variant then. */
static enum um_status find_precomputed(struct um_context *context,
                                       struct um_sensitivity_forward *forward,
                                       struct um_model_addition **key, size_t nkey,
                                       struct variant *v, struct um_sensitivity_cached **out)
{
  struct um_sensitivity_forward_cache *cache = forward->cache;
  struct um_sensitivity_cached *oldest = &cache->kept[0];
  *out = &cache->own;
  if (nkey == 0) return UM_OK;
  *out = um_sensitivity_moves_precomputed(forward->cache->moves, *key, nkey);
  if (*out != NULL) return UM_OK;
  for (size_t i = 0; i < UM_SENSITIVITY_CACHED; i++) {
    struct um_sensitivity_cached *t = *out = &cache->kept[i];
    if (t->model != NULL && um_sensitivity_variant_same_key(t->key, t->nkey, *key, nkey))
      return UM_OK;
    if (t->used < oldest->used) oldest = t;
  }
  um_sensitivity_cached_clear(context, oldest);
  UM_TRY(um_compare_plan_trace(context, v->model, forward->plan, &oldest->precomputed));
  oldest->key = *key;
  oldest->nkey = nkey;
  *key = NULL;
  oldest->model = v->model;
  v->model = NULL;
  *out = oldest;
  return UM_OK;
}

/* Heat that is at hand, by the answer to a move (or NULL), or new; new heat on a geometry
 * precomputation that has none stays with it. */
static enum um_status find_heat(struct um_context *context, struct um_sensitivity_forward *forward,
                                const struct um_sensitivity_move *move,
                                struct um_sensitivity_cached *cached, struct variant *v)
{
  struct um_sensitivity_forward_cache *cache = forward->cache;
  struct um_model_thermal_solution *heat = NULL;
  cache->fresh_heat = cache->moved_heat = false;
  v->heat = cached->heat;
  bool matches = false;
  if (v->heat != NULL)
    UM_TRY(um_model_thermal_solution_matches(context, v->heat, v->used, v->precomputed, &matches));
  if (matches) return UM_OK;
  v->heat = cache->own.heat;
  UM_TRY(um_model_thermal_solution_matches(context, v->heat, v->used, v->precomputed, &matches));
  if (matches) return UM_OK;
  cache->fresh_heat = true;
  const struct um_sensitivity_moved *moved = um_sensitivity_moves_of(cache->moves, move);
  if (moved != NULL) {
    cache->moved_heat = true;
    UM_TRY(um_model_thermal_solution_move(context, cache->own.heat, moved->sensitivity,
                                          moved->which, move->step, v->used, v->precomputed,
                                          &v->own_heat));
    v->heat = v->own_heat;
    return UM_OK;
  }
  double begin = omp_get_wtime();
  UM_TRY(um_model_thermal_solution_create(context, v->used, v->precomputed, cache->own.heat,
                                          forward->tolerance_factor, &heat));
  forward->heat_runs++;
  forward->heat_seconds += omp_get_wtime() - begin;
  v->heat = heat;
  if (v->used == cached->model && cached->heat == NULL)
    cached->heat = heat;
  else
    v->own_heat = heat;
  return UM_OK;
}

static enum um_status variant_make(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   const struct um_model_addition *addition, size_t naddition,
                                   const struct um_sensitivity_move *move, struct variant *v)
{
  enum um_status status;
  struct um_sensitivity_cached *cached = NULL;
  struct um_model_addition *key = NULL;
  size_t nkey;
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  *v = (struct variant){0};
  UM_CHECK(um_model_variant_create(context, forward->model, &changes, &v->model));
  v->used = v->model;
  UM_CHECK(um_core_allocate(context, naddition, sizeof *key, &key));
  nkey = um_sensitivity_variant_key(forward->model, v->model, addition, naddition, key);
  UM_CHECK(find_precomputed(context, forward, &key, nkey, v, &cached));
  cached->used = forward->evaluations + 1;
  v->precomputed = cached->precomputed;
  UM_CHECK(find_heat(context, forward, move, cached, v));
done:
  um_core_free(context, key);
  return status;
}

/* --- values ---------------------------------------------------------------------------------- */

static enum um_status predict(struct um_context *context, struct um_sensitivity_forward *forward,
                              const struct um_model *model,
                              const struct um_model_precomputed *precomputed,
                              const struct um_model_thermal_solution *heat)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_model_run_observed(context, model, precomputed, heat, &result));
  enum um_status status =
      um_compare_predict(context, forward->plan, precomputed, result, forward->cache->predicted);
  um_model_result_destroy(context, &result);
  return status;
}

/* Observations in use from the prediction of all. */
static enum um_status gather(struct um_context *context,
                             const struct um_sensitivity_forward *forward, double *value)
{
  const struct um_compare_measurements *m = forward->measurements;
  const struct um_sensitivity_observations *o = &forward->observations;
  um_compare_modelled(m, o->count, o->row, forward->cache->predicted, value);
  for (size_t j = 0; j < o->count; j++) {
    const struct um_compare_channel *channel = &m->channel[o->channel[j]];
    if (!isfinite(value[j]))
      return um_core_fail(context, UM_ERR_INPUT, "%s:%d: the model gives %s '%s' of %g", m->path,
                          m->row[o->row[j]].line, um_compare_quantity_name(channel->quantity),
                          channel->of, value[j]);
  }
  return UM_OK;
}

static enum um_status evaluate(struct um_context *context, struct um_sensitivity_forward *forward,
                               const struct um_model_addition *addition, size_t naddition,
                               const struct um_sensitivity_move *move, double *value)
{
  enum um_status status;
  struct variant v = {0};
  UM_CHECK(variant_make(context, forward, addition, naddition, move, &v));
  UM_CHECK(predict(context, forward, v.used, v.precomputed, v.heat));
  UM_CHECK(gather(context, forward, value));
done:
  variant_release(context, &v);
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

enum um_status um_sensitivity_forward_evaluate(struct um_context *context,
                                               struct um_sensitivity_forward *forward,
                                               const struct um_model_addition *addition,
                                               size_t naddition, double *value)
{
  return evaluate_timed(context, forward, addition, naddition, NULL, value);
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

static enum um_status repeat(struct um_context *context, struct um_sensitivity_forward *forward,
                             double *value)
{
  enum um_status status;
  struct um_sensitivity_forward_cache *cache = forward->cache;
  struct um_model_thermal_solution *heat = NULL;
  UM_CHECK(um_model_thermal_solution_create(context, forward->model, cache->own.precomputed,
                                            cache->own.heat, forward->tolerance_factor, &heat));
  UM_CHECK(predict(context, forward, forward->model, cache->own.precomputed, heat));
  UM_CHECK(gather(context, forward, value));
done:
  um_model_thermal_solution_destroy(context, &heat);
  return status;
}

enum um_status um_sensitivity_forward_noise(struct um_context *context,
                                            struct um_sensitivity_forward *forward, double *out)
{
  enum um_status status = UM_OK;
  double *value = NULL, largest = 0.0, begin = omp_get_wtime();
  *out = forward->cache->noise;
  if (!isnan(*out)) return UM_OK;
  um_core_quiet_begin(context);
  UM_CHECK(um_core_allocate(context, forward->observations.count, sizeof *value, &value));
  UM_CHECK(repeat(context, forward, value));
  for (size_t j = 0; j < forward->observations.count; j++)
    largest =
        fmax(largest, fabs(value[j] - forward->cache->base[j]) / forward->observations.sigma[j]);
  *out = forward->cache->noise = largest;
done:
  um_core_quiet_end(context);
  um_core_free(context, value);
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
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
  struct um_sensitivity_cached *own = &f->cache->own;
  struct um_compare_share_user user = {f->model, f->plan};
  struct um_compare_refinement refinement;
  f->samples = f->samples_before = f->model->scenario->optics->samples;
  f->paths = f->model->scenario->optics->interreflection_samples;
  if (!has_light(f)) return um_model_run_with(context, f->model, own->precomputed, own->heat, out);
  UM_TRY(um_compare_refine_with(context, f->model, own->precomputed, own->heat,
                                UM_COMPARE_MODEL_SHARE, um_compare_share_of_plan, &user, out,
                                &refinement));
  f->samples = refinement.samples;
  f->paths = refinement.interreflection;
  return UM_OK;
}

static enum um_status first_evaluation(struct um_context *context,
                                       struct um_sensitivity_forward *forward)
{
  struct um_sensitivity_forward_cache *cache = forward->cache;
  struct um_model_result *result = NULL;
  enum um_status status;
  double begin = omp_get_wtime();
  UM_CHECK(um_compare_plan_trace(context, forward->model, forward->plan, &cache->own.precomputed));
  UM_CHECK(um_model_thermal_solution_create(context, forward->model, cache->own.precomputed, NULL,
                                            forward->tolerance_factor, &cache->own.heat));
  forward->precomputed = cache->own.precomputed;
  forward->thermal_solution = cache->own.heat;
  UM_CHECK(first_run(context, forward, &result));
  UM_CHECK(
      um_compare_predict(context, forward->plan, cache->own.precomputed, result, cache->predicted));
  UM_CHECK(um_sensitivity_observations_create(context, forward->plan, forward->model->scenario,
                                              result, cache->predicted, &forward->observations));
  UM_CHECK(
      um_core_allocate(context, forward->observations.count, sizeof *cache->base, &cache->base));
  UM_CHECK(gather(context, forward, cache->base));
  forward->evaluations = 1;
  forward->seconds = forward->seconds_first = omp_get_wtime() - begin;
done:
  um_model_result_destroy(context, &result);
  return status;
}

enum um_status um_sensitivity_forward_create(struct um_context *context, const char *path,
                                             const struct um_model_options *options,
                                             const struct um_compare_measurements *measurements,
                                             double tolerance_factor,
                                             struct um_sensitivity_forward **out)
{
  enum um_status status;
  struct um_sensitivity_forward *f = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(um_core_allocate(context, 1, sizeof *f->cache, &f->cache));
  f->measurements = measurements;
  f->tolerance_factor = tolerance_factor;
  f->cache->noise = NAN;
  if (options != NULL) f->options = *options;
  UM_CHECK(um_core_files_hold(context));
  f->holds_files = true;
  UM_CHECK(um_model_create(context, path, options, &f->model));
  UM_CHECK(um_compare_plan_create(context, f->model, measurements, &f->plan));
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
    for (size_t i = 0; i < UM_SENSITIVITY_CACHED; i++)
      um_sensitivity_cached_clear(context, &f->cache->kept[i]);
    um_sensitivity_cached_clear(context, &f->cache->own);
    um_core_free(context, f->cache->predicted);
    um_core_free(context, f->cache->base);
    um_core_free(context, f->cache);
  }
  um_sensitivity_observations_release(context, &f->observations);
  um_compare_plan_destroy(context, &f->plan);
  um_model_destroy(context, &f->model);
  if (f->holds_files) um_core_files_let_go(context);
  um_core_free(context, f);
  *forward = NULL;
}

/* --- everything of one variant --------------------------------------------------------------- */

enum um_status um_sensitivity_forward_run(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_model_addition *addition,
                                          size_t naddition, bool grid,
                                          struct um_sensitivity_forward_run *out)
{
  enum um_status status;
  struct um_model_thermal_solution *heat = NULL;
  const struct um_model_changes changes = {.addition = addition, .naddition = naddition};
  *out = (struct um_sensitivity_forward_run){0};
  um_core_quiet_begin(context);
  UM_CHECK(um_model_variant_create(context, forward->model, &changes, &out->model));
  if (grid && !out->model->points) /* points have no window of their own */
    UM_CHECK(um_model_precompute(context, out->model, &out->precomputed));
  else
    UM_CHECK(um_compare_plan_trace(context, out->model, forward->plan, &out->precomputed));
  UM_CHECK(um_model_thermal_solution_create(context, out->model, out->precomputed,
                                            forward->cache->own.heat, forward->tolerance_factor,
                                            &heat));
  UM_CHECK(um_model_run_with(context, out->model, out->precomputed, heat, &out->result));
done:
  um_core_quiet_end(context);
  um_model_thermal_solution_destroy(context, &heat);
  if (status != UM_OK) um_sensitivity_forward_run_release(context, out);
  return status == UM_ERR_INPUT && naddition > 0 ? UM_ERR_REFUSED : status;
}

void um_sensitivity_forward_run_release(struct um_context *context,
                                        struct um_sensitivity_forward_run *run)
{
  um_model_result_destroy(context, &run->result);
  um_model_precomputed_destroy(context, &run->precomputed);
  um_model_destroy(context, &run->model);
}
