/* umbra diagnose: which effect a scenario lacks. */
#include "evidence/diagnosis/diagnose.h"
#include "app/diagnosis.h"

static enum um_status diagnose(struct um_context *context, const struct um_app_options *options,
                               struct um_app_diagnosis *work)
{
  UM_TRY(um_app_diagnosis_begin(context, options, work));
  const struct um_diagnosis_options wanted = {
      .candidates = {.only = options->only,
                     .nonly = options->nonly,
                     .exclude = work->request.exclude,
                     .nexclude = work->request.nexclude},
      .nuisance = work->request.nuisance,
      .nnuisance = work->request.nnuisance,
      .level = options->level,
      .steps_max = (size_t)options->steps,
      .passes = (size_t)options->passes,
      .draft = options->draft_effect != NULL,
  };
  UM_TRY(um_sensitivity_candidates_create(context, work->forward, NULL, 0, &wanted.candidates,
                                          &work->candidates));
  UM_TRY(um_diagnosis_create(context, work->forward, work->candidates, &wanted, &work->diagnosis));
  return um_app_diagnosis_finish(context, options, work);
}

int um_app_diagnose(struct um_context *context, const struct um_app_options *options)
{
  struct um_app_diagnosis work = {0};
  enum um_status status = diagnose(context, options, &work);
  um_app_diagnosis_release(context, &work);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
