/* Diagnoses and fits as results. */
#include "evidence/diagnosis/diagnose.h"

#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"
#include "effects/effects.h"
#include "evidence/diagnosis/report/write.h"
#include "library/diagnosis_impl.h"
#include "library/scenario_impl.h"
#include "model/build/effect_files.h"
#include "model/build/effects.h"

#define STEPS_MOST 20 /* as the command takes */

static void diagnosis_release(struct um_context *context, void *work)
{
  struct um_library_diagnosis *d = work;
  um_diagnosis_destroy(context, &d->diagnosis);
  um_sensitivity_candidates_destroy(context, &d->candidates);
  um_diagnosis_request_release(context, &d->request);
  um_sensitivity_forward_destroy(context, &d->forward);
  um_library_measurements_drop(&d->measurements);
  um_library_source_release(context, &d->source);
  um_library_source_release(context, &d->wanted);
  um_core_arena_release(context, &d->memory);
  um_core_free(context, d);
}

static enum um_status diagnosis_write(struct um_context *context, const struct umbra_result *result,
                                      const struct umbra_write *write,
                                      struct um_core_folder *folder)
{
  const struct um_diagnosis *d = ((const struct um_library_diagnosis *)result->work)->diagnosis;
  return um_diagnosis_report_write(context, d, write->command, UM_LIBRARY_VERSION,
                                   write->pictures != 0, folder);
}

static const struct um_model *diagnosis_model(const void *work)
{
  return ((const struct um_library_diagnosis *)work)->forward->model;
}

static const struct um_library_kind kind = {diagnosis_write, diagnosis_release, diagnosis_model};

/* Measurements, forward, and what the scenario asks for. */
static enum um_status begin(struct umbra *umbra, const struct umbra_scenario *scenario,
                            struct umbra_measurements *measurements,
                            const struct um_diagnosis_request_texts *texts,
                            struct um_library_diagnosis *work)
{
  struct um_context *context = umbra->context;
  work->measurements = um_library_measurements_share(measurements);
  UM_TRY(um_library_source_copy(context, &scenario->source, &work->source));
  work->options = um_library_source_options(&work->source, umbra);
  UM_TRY(um_sensitivity_forward_create(context, work->source.path, &work->options,
                                       measurements->set, UM_VARIANT_TIGHT, &work->forward));
  struct um_diagnosis_request_texts of = *texts;
  of.measurements = measurements->set;
  return um_diagnosis_request_make(context, work->forward->model, &of, &work->request);
}

static enum um_status show(struct um_context *context, const struct um_library_diagnosis *work,
                           struct umbra_result *result)
{
  const struct um_sensitivity_observations *o = &work->forward->observations;
  const struct umbra_array before = {.name = "before",
                                     .unit = "of residuals",
                                     .shape = {o->count},
                                     .axis = {"fitted observation"},
                                     .data = work->diagnosis->value_before};
  struct umbra_array after = before;
  after.name = "after";
  after.data = work->diagnosis->value_after;
  UM_TRY(um_library_result_show(context, result, &before));
  return um_library_result_show(context, result, &after);
}

/* The work is done: a result of it, which takes it over. */
static enum um_status finish(struct um_context *context, struct umbra *umbra,
                             struct um_library_diagnosis **work, struct umbra_result **out)
{
  UM_TRY(um_library_verdict(context, *work));
  UM_TRY(um_library_result_create(context, umbra, &kind, *work, out));
  *work = NULL;
  return show(context, (*out)->work, *out);
}

static enum um_status check_settings(struct um_context *context,
                                     const struct umbra_diagnose_settings *s)
{
  if (!(s->level >= 0.0 && s->level < 1.0))
    return um_core_fail(context, UM_ERR_INPUT, "level %g; accepted: 0 to below 1", s->level);
  if (s->steps <= STEPS_MOST) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "steps %zu; accepted: 0 to %d", s->steps, STEPS_MOST);
}

enum umbra_status umbra_diagnose(struct umbra *umbra, const struct umbra_scenario *scenario,
                                 struct umbra_measurements *measurements,
                                 const struct umbra_diagnose_settings *settings,
                                 struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_diagnose_settings asked = UMBRA_DIAGNOSE_SETTINGS;
  struct um_library_diagnosis *work = NULL;
  struct umbra_result *result = NULL;
  enum um_status status;
  *out = NULL;
  if (settings != NULL) {
    UM_CHECK(um_library_check_size(context, "struct umbra_diagnose_settings", settings->size,
                                   sizeof *settings));
    asked = *settings;
  }
  UM_CHECK(check_settings(context, &asked));
  const struct um_diagnosis_request_texts texts = {.exclude = asked.exclude,
                                                   .nexclude = asked.nexclude};
  UM_CHECK(um_core_allocate(context, 1, sizeof *work, &work));
  UM_CHECK(begin(umbra, scenario, measurements, &texts, work));
  const struct um_diagnosis_options options = {
      .candidates = {.only = asked.only,
                     .nonly = asked.nonly,
                     .exclude = work->request.exclude,
                     .nexclude = work->request.nexclude},
      .nuisance = work->request.nuisance,
      .nnuisance = work->request.nnuisance,
      .level = asked.level,
      .steps_max = asked.steps,
  };
  UM_CHECK(um_sensitivity_candidates_create(context, work->forward, NULL, 0, &options.candidates,
                                            &work->candidates));
  UM_CHECK(
      um_diagnosis_create(context, work->forward, work->candidates, &options, &work->diagnosis));
  UM_CHECK(finish(context, umbra, &work, &result));
  *out = result;
done:
  if (work != NULL) diagnosis_release(context, work);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}

/* A change as a fit wants it: parameters that are not named have no start. */
static enum um_status wanted_of(struct um_context *context, const struct um_model *model,
                                const struct um_model_change *change, struct um_model_addition *out)
{
  const struct um_effect *effect = um_model_effects_find(model, change->effect);
  if (effect == NULL) return um_effects_registry_refuse(context, model->registry, change->effect);
  UM_TRY(um_model_check_target(context, model, effect, change->target));
  *out = (struct um_model_addition){.effect = effect, .target = change->target};
  for (size_t p = 0; p < effect->nparameter; p++) out->value[p] = NAN;
  for (size_t i = 0; i < change->nparameter; i++) {
    size_t p = um_effects_parameter_find(effect, change->parameter[i]);
    if (p < effect->nparameter) out->value[p] = change->value[i];
  }
  return UM_OK;
}

static enum um_status fit(struct um_context *context, struct um_library_diagnosis *work)
{
  const struct um_diagnosis_options options = {.nuisance = work->request.nuisance,
                                               .nnuisance = work->request.nnuisance};
  const struct um_library_source *wanted = &work->wanted;
  struct um_model_addition *addition = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, wanted->nchange, sizeof *addition, &addition));
  for (size_t i = 0; i < wanted->nchange; i++) {
    UM_CHECK(wanted_of(context, work->forward->model, &wanted->change[i], &addition[i]));
    for (size_t k = 0; k < i; k++)
      if (addition[k].effect == addition[i].effect &&
          um_core_words_same(addition[k].target, addition[i].target))
        UM_CHECK(um_core_fail(context, UM_ERR_INPUT, "%s is asked for twice; accepted: once",
                              addition[i].effect->name));
  }
  UM_CHECK(um_diagnosis_fit_effects(context, work->forward, addition, wanted->nchange, &options,
                                    &work->diagnosis));
done:
  um_core_free(context, addition);
  return status;
}

enum umbra_status umbra_fit(struct umbra *umbra, const struct umbra_scenario *scenario,
                            struct umbra_measurements *measurements,
                            const struct umbra_effect_change *change, size_t nchange,
                            struct umbra_result **out)
{
  struct um_context *context = um_library_begin(umbra);
  static const struct um_diagnosis_request_texts nothing;
  struct um_library_diagnosis *work = NULL;
  struct umbra_result *result = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *work, &work));
  for (size_t i = 0; i < nchange; i++) {
    UM_CHECK(um_library_take_change(context, umbra->registry, &change[i], &work->wanted));
    if (change[i].off != 0)
      UM_CHECK(um_core_fail(context, UM_ERR_INPUT, "%s is off; accepted: effects that are fitted",
                            change[i].effect));
  }
  UM_CHECK(begin(umbra, scenario, measurements, &nothing, work));
  UM_CHECK(fit(context, work));
  UM_CHECK(finish(context, umbra, &work, &result));
  *out = result;
done:
  if (work != NULL) diagnosis_release(context, work);
  if (status != UM_OK) umbra_result_close(&result);
  return um_library_status(status);
}

const struct umbra_verdict *umbra_result_verdict(const struct umbra_result *result)
{
  return result->kind == &kind ? &((const struct um_library_diagnosis *)result->work)->verdict
                               : NULL;
}
