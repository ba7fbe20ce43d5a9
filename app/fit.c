/* umbra fit: parameters of chosen effects. */
#include "app/diagnosis.h"
#include "evidence/diagnosis/diagnose.h"

static enum um_status fit(struct um_context *context, const struct um_app_options *options,
                          struct um_app_diagnosis *work)
{
  UM_TRY(um_app_diagnosis_begin(context, options, work));
  const struct um_diagnosis_options wanted = {.nuisance = work->request.nuisance,
                                              .nnuisance = work->request.nnuisance};
  UM_TRY(um_diagnosis_fit_effects(context, work->forward, work->request.wanted,
                                  work->request.nwanted, &wanted, &work->diagnosis));
  return um_app_diagnosis_finish(context, options, work);
}

int um_app_fit(struct um_context *context, const struct um_app_options *options)
{
  struct um_app_diagnosis work = {0};
  enum um_status status = fit(context, options, &work);
  um_app_diagnosis_release(context, &work);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
