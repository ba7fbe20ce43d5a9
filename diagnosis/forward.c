/* Evaluations of a scenario with effects added. Heat of a variant starts from the scenario's own
 * periodic state, never from the variant before, so that a value does not depend on what was
 * computed earlier. */
#include "diagnosis/forward.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "compare/series.h"
#include "diagnosis/forward_impl.h"

static void traced_clear(struct um_context *context, struct um_diagnosis_traced *traced)
{
  um_core_free(context, traced->key);
  um_model_heat_destroy(context, &traced->heat);
  um_model_trace_destroy(context, &traced->trace);
  um_model_destroy(context, &traced->model);
  *traced = (struct um_diagnosis_traced){0};
}

void um_diagnosis_forward_null(const struct um_diagnosis_forward *forward,
                               const struct um_effect *effect, const char *target, double *value)
{
  for (size_t p = 0; p < effect->nparameter; p++) value[p] = effect->parameters[p].null_value;
  for (size_t i = 0; i < forward->model->neffect; i++) {
    const struct um_model_effect *e = &forward->model->effect[i];
    if (e->off || e->effect != effect ||
        strcmp(e->target == NULL ? "" : e->target, target == NULL ? "" : target) != 0)
      continue;
    memcpy(value, e->value, effect->nparameter * sizeof *value);
  }
}

/* --- a variant with its trace and heat ------------------------------------------------------- */

/* What a variant is computed with; what is owned here is released after the evaluation. */
struct variant {
  struct um_model *model; /* owned, until it is kept with a trace */
  const struct um_model *used;
  const struct um_model_trace *trace;
  const struct um_model_heat *heat;
  struct um_model_heat *own_heat;
};

static void variant_release(struct um_context *context, struct variant *v)
{
  um_model_heat_destroy(context, &v->own_heat);
  um_model_destroy(context, &v->model);
}

/* The kept trace of this key, made when there is none; it takes the variant's model then. */
static enum um_status find_trace(struct um_context *context, struct um_diagnosis_forward *forward,
                                 char **key, struct variant *v, struct um_diagnosis_traced **out)
{
  struct um_diagnosis_forward_cache *cache = forward->cache;
  struct um_diagnosis_traced *oldest = &cache->kept[0];
  if ((*key)[0] == '\0') {
    *out = &cache->own;
    return UM_OK;
  }
  for (size_t i = 0; i < UM_DIAGNOSIS_TRACES; i++) {
    struct um_diagnosis_traced *t = &cache->kept[i];
    if (t->key != NULL && strcmp(t->key, *key) == 0) {
      *out = t;
      return UM_OK;
    }
    if (t->used < oldest->used) oldest = t;
  }
  traced_clear(context, oldest);
  UM_TRY(um_compare_plan_trace(context, v->model, forward->plan, &oldest->trace));
  oldest->key = *key;
  *key = NULL;
  oldest->model = v->model;
  v->model = NULL;
  *out = oldest;
  return UM_OK;
}

/* Heat that is at hand or new; new heat on a trace that has none stays with it. */
static enum um_status find_heat(struct um_context *context, struct um_diagnosis_forward *forward,
                                struct um_diagnosis_traced *traced, struct variant *v)
{
  struct um_diagnosis_forward_cache *cache = forward->cache;
  struct um_model_heat *heat = NULL;
  cache->fresh_heat = false;
  v->heat = traced->heat;
  if (v->heat != NULL && um_model_heat_matches(v->heat, v->used, v->trace)) return UM_OK;
  v->heat = cache->own.heat;
  if (um_model_heat_matches(v->heat, v->used, v->trace)) return UM_OK;
  cache->fresh_heat = true;
  UM_TRY(um_model_heat_create(context, v->used, v->trace, cache->own.heat, cache->loosened, &heat));
  v->heat = heat;
  if (v->used == traced->model && traced->heat == NULL)
    traced->heat = heat;
  else
    v->own_heat = heat;
  return UM_OK;
}

static enum um_status variant_make(struct um_context *context, struct um_diagnosis_forward *forward,
                                   const struct um_diagnosis_addition *addition, size_t naddition,
                                   struct variant *v)
{
  enum um_status status;
  struct um_diagnosis_traced *traced = NULL;
  char *key = NULL;
  *v = (struct variant){0};
  UM_CHECK(um_diagnosis_variant_create(context, forward, addition, naddition, &v->model));
  v->used = v->model;
  UM_CHECK(um_diagnosis_variant_key(context, forward, v->model, addition, naddition, &key));
  UM_CHECK(find_trace(context, forward, &key, v, &traced));
  traced->used = forward->evaluations + 1;
  v->trace = traced->trace;
  UM_CHECK(find_heat(context, forward, traced, v));
done:
  um_core_free(context, key);
  return status;
}

/* --- values ---------------------------------------------------------------------------------- */

static enum um_status predict(struct um_context *context, struct um_diagnosis_forward *forward,
                              const struct um_model *model, const struct um_model_trace *trace,
                              const struct um_model_heat *heat)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_model_run_with(context, model, trace, heat, &result));
  enum um_status status =
      um_compare_predict(context, forward->plan, trace, result, forward->cache->predicted);
  um_model_result_destroy(context, &result);
  return status;
}

/* Rows in use from the prediction of all. */
static enum um_status gather(struct um_context *context, const struct um_diagnosis_forward *forward,
                             double *value)
{
  const struct um_compare_measurements *m = forward->measurements;
  for (size_t j = 0; j < forward->nrow; j++) {
    double unused;
    size_t row = forward->row[j];
    um_compare_linear(m->channel[forward->channel[j]].quantity, forward->cache->predicted[row], NAN,
                      &value[j], &unused);
    if (!isfinite(value[j]))
      return um_core_fail(context, UM_ERR_INPUT, "%s:%d: the model gives %s '%s' of %g", m->path,
                          m->row[row].line,
                          um_compare_quantity_name(m->channel[forward->channel[j]].quantity),
                          m->channel[forward->channel[j]].of, value[j]);
  }
  return UM_OK;
}

static enum um_status evaluate(struct um_context *context, struct um_diagnosis_forward *forward,
                               const struct um_diagnosis_addition *addition, size_t naddition,
                               double *value)
{
  enum um_status status;
  struct variant v = {0};
  UM_CHECK(variant_make(context, forward, addition, naddition, &v));
  UM_CHECK(predict(context, forward, v.used, v.trace, v.heat));
  UM_CHECK(gather(context, forward, value));
done:
  variant_release(context, &v);
  return status;
}

enum um_status um_diagnosis_forward_evaluate(struct um_context *context,
                                             struct um_diagnosis_forward *forward,
                                             const struct um_diagnosis_addition *addition,
                                             size_t naddition, double *value)
{
  double begin = omp_get_wtime();
  enum um_status status = UM_OK;
  if (naddition == 0) {
    forward->cache->fresh_heat = false;
    memcpy(value, forward->cache->base, forward->nrow * sizeof *value);
  } else {
    um_core_quiet_begin(context);
    status = evaluate(context, forward, addition, naddition, value);
    um_core_quiet_end(context);
  }
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

static enum um_status repeat(struct um_context *context, struct um_diagnosis_forward *forward,
                             double *value)
{
  enum um_status status;
  struct um_diagnosis_forward_cache *cache = forward->cache;
  struct um_model_heat *heat = NULL;
  UM_CHECK(um_model_heat_create(context, forward->model, cache->own.trace, cache->own.heat,
                                cache->loosened, &heat));
  UM_CHECK(predict(context, forward, forward->model, cache->own.trace, heat));
  UM_CHECK(gather(context, forward, value));
done:
  um_model_heat_destroy(context, &heat);
  return status;
}

enum um_status um_diagnosis_forward_noise(struct um_context *context,
                                          struct um_diagnosis_forward *forward, double *out)
{
  enum um_status status = UM_OK;
  double *value = NULL, largest = 0.0, begin = omp_get_wtime();
  *out = forward->cache->noise;
  if (!isnan(*out)) return UM_OK;
  um_core_quiet_begin(context);
  UM_CHECK(um_core_allocate(context, forward->nrow, sizeof *value, &value));
  UM_CHECK(repeat(context, forward, value));
  for (size_t j = 0; j < forward->nrow; j++)
    largest = fmax(largest, fabs(value[j] - forward->cache->base[j]) / forward->sigma[j]);
  *out = forward->cache->noise = largest;
done:
  um_core_quiet_end(context);
  um_core_free(context, value);
  forward->evaluations++;
  forward->seconds += omp_get_wtime() - begin;
  return status;
}

/* --- life ------------------------------------------------------------------------------------ */

static enum um_status first_evaluation(struct um_context *context,
                                       struct um_diagnosis_forward *forward)
{
  struct um_diagnosis_forward_cache *cache = forward->cache;
  double begin = omp_get_wtime();
  UM_TRY(um_compare_plan_trace(context, forward->model, forward->plan, &cache->own.trace));
  UM_TRY(um_model_heat_create(context, forward->model, cache->own.trace, NULL, cache->loosened,
                              &cache->own.heat));
  UM_TRY(predict(context, forward, forward->model, cache->own.trace, cache->own.heat));
  UM_TRY(um_diagnosis_rows_create(context, forward));
  UM_TRY(gather(context, forward, cache->base));
  forward->evaluations = 1;
  forward->seconds = forward->seconds_first = omp_get_wtime() - begin;
  return UM_OK;
}

enum um_status um_diagnosis_forward_create(struct um_context *context, const char *path,
                                           const struct um_model_options *options,
                                           const struct um_compare_measurements *measurements,
                                           double loosened, struct um_diagnosis_forward **out)
{
  enum um_status status;
  struct um_diagnosis_forward *f = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *f, &f));
  UM_CHECK(um_core_allocate(context, 1, sizeof *f->cache, &f->cache));
  f->path = path;
  f->measurements = measurements;
  f->cache->loosened = loosened;
  f->cache->noise = NAN;
  if (options != NULL) f->cache->options = *options;
  UM_CHECK(um_model_create(context, path, options, &f->model));
  UM_CHECK(um_compare_plan_create(context, f->model, measurements, &f->plan));
  UM_CHECK(um_core_allocate(context, measurements->count, sizeof *f->cache->predicted,
                            &f->cache->predicted));
  UM_CHECK(first_evaluation(context, f));
  *out = f;
  f = NULL;
done:
  um_diagnosis_forward_destroy(context, &f);
  return status;
}

void um_diagnosis_forward_destroy(struct um_context *context, struct um_diagnosis_forward **forward)
{
  if (forward == NULL || *forward == NULL) return;
  struct um_diagnosis_forward *f = *forward;
  if (f->cache != NULL) {
    for (size_t i = 0; i < UM_DIAGNOSIS_TRACES; i++) traced_clear(context, &f->cache->kept[i]);
    traced_clear(context, &f->cache->own);
    um_core_free(context, f->cache->predicted);
    um_core_free(context, f->cache->base);
    um_core_free(context, f->cache);
  }
  um_core_free(context, f->row);
  um_core_free(context, f->channel);
  um_core_free(context, f->t);
  um_core_free(context, f->measured);
  um_core_free(context, f->sigma);
  um_compare_plan_destroy(context, &f->plan);
  um_model_destroy(context, &f->model);
  um_core_free(context, f);
  *forward = NULL;
}

/* --- everything of one variant --------------------------------------------------------------- */

enum um_status um_diagnosis_forward_run(struct um_context *context,
                                        const struct um_diagnosis_forward *forward,
                                        const struct um_diagnosis_addition *addition,
                                        size_t naddition, bool grid,
                                        struct um_diagnosis_forward_run *out)
{
  enum um_status status;
  struct um_model_heat *heat = NULL;
  *out = (struct um_diagnosis_forward_run){0};
  um_core_quiet_begin(context);
  UM_CHECK(um_diagnosis_variant_create(context, forward, addition, naddition, &out->model));
  if (grid && !out->model->points) /* points have no window of their own */
    UM_CHECK(um_model_trace_create(context, out->model, &out->trace));
  else
    UM_CHECK(um_compare_plan_trace(context, out->model, forward->plan, &out->trace));
  UM_CHECK(um_model_heat_create(context, out->model, out->trace, forward->cache->own.heat,
                                forward->cache->loosened, &heat));
  UM_CHECK(um_model_run_with(context, out->model, out->trace, heat, &out->result));
done:
  um_core_quiet_end(context);
  um_model_heat_destroy(context, &heat);
  if (status != UM_OK) um_diagnosis_forward_run_release(context, out);
  return status;
}

void um_diagnosis_forward_run_release(struct um_context *context,
                                      struct um_diagnosis_forward_run *run)
{
  um_model_result_destroy(context, &run->result);
  um_model_trace_destroy(context, &run->trace);
  um_model_destroy(context, &run->model);
}
