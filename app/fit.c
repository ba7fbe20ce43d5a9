/* umbra fit: parameters of chosen effects. */
#include <math.h>

#include "app/diagnosis.h"
#include "base/core/csv.h"
#include "evidence/diagnosis/diagnose.h"

#define SEED_MAX 9007199254740992.0 /* 2^53 */

static enum um_status fit(struct um_context *context, const struct um_app_options *options,
                          double seed, struct um_app_diagnosis *work)
{
  UM_TRY(um_app_diagnosis_begin(context, options, work));
  const struct um_diagnosis_options wanted = {.nuisance = work->request.nuisance,
                                              .nnuisance = work->request.nnuisance,
                                              .draws = !options->posterior  ? 0
                                                       : options->draws > 0 ? (size_t)options->draws
                                                                            : UM_APP_DRAWS,
                                              .seed = (uint64_t)seed};
  UM_TRY(um_diagnosis_fit_effects(context, work->forward, work->request.wanted,
                                  work->request.nwanted, &wanted, &work->diagnosis));
  return um_app_diagnosis_finish(context, options, work);
}

int um_app_fit(struct um_context *context, const struct um_app_options *options)
{
  struct um_app_diagnosis work = {0};
  double seed = 1.0;
  int misuse = options->posterior
                   ? UM_APP_DONE
                   : um_app_options_refuse(options, "draws draw-seed", "needs --posterior");
  if (misuse != UM_APP_DONE) return misuse;
  if (options->seed != NULL && (!um_core_number_parse(options->seed, &seed) ||
                                !(seed >= 0.0 && seed <= SEED_MAX) || seed != floor(seed)))
    return um_app_misuse(NULL, "--seed takes a whole number from 0 to 2^53, not '%s'",
                         options->seed);
  enum um_status status = fit(context, options, seed, &work);
  um_app_diagnosis_release(context, &work);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
