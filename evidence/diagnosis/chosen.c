/* Effects that a person chose, fitted as a diagnosis fits those that it finds, under the noise that
 * a diagnosis would weigh by: where what they leave is not noise of the stated sigma, what it is is
 * estimated, and they are fitted anew with it. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* Sort the additions into the order of the request. */
static void put_as_wanted(const struct um_model_addition *wanted, struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->naddition; i++)
    for (size_t j = i + 1; j < d->naddition; j++) {
      if (d->addition[j].effect != wanted[i].effect || d->addition[j].target != wanted[i].target)
        continue;
      struct um_model_addition a = d->addition[i];
      double sigma[UM_EFFECT_PARAMETERS_MAX];
      memcpy(sigma, d->addition_sigma[i], sizeof sigma);
      d->addition[i] = d->addition[j];
      memcpy(d->addition_sigma[i], d->addition_sigma[j], sizeof sigma);
      d->addition[j] = a;
      memcpy(d->addition_sigma[j], sigma, sizeof sigma);
    }
}

/* Where what is left is not noise of the stated sigma: all anew by what it is, until that does not
 * change the fit. */
static enum um_status weigh(struct um_context *context, struct um_diagnosis_work *work,
                            struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  enum um_status status;
  struct um_inference_whiteness whiteness;
  bool white = false;
  UM_TRY(um_diagnosis_state_whiteness(context, work, state, &whiteness));
  if (um_diagnosis_is_noise(&whiteness)) return UM_OK;
  um_core_progress_begin(context, "estimating the noise", UM_DIAGNOSIS_NOISE_ROUNDS);
  UM_CHECK(um_diagnosis_discrepancy_create(context, work->forward, &work->discrepancy));
  for (int round = 0; round < UM_DIAGNOSIS_NOISE_ROUNDS && !white; round++) {
    double before = work->noise == NULL ? INFINITY : state->fit->bic;
    UM_CHECK(um_diagnosis_noise_take(context, work, state->fit->residual, &white));
    if (!white)
      UM_CHECK(um_diagnosis_state_fit(context, work, state, state->fit->value, NULL, INFINITY));
    UM_CHECK(um_core_progress_step(context, 1));
    if (!(state->fit->bic < before - UM_DIAGNOSIS_SETTLED)) break;
  }
  d->weighed = work->noise != NULL;
done:
  um_core_progress_end(context);
  return status;
}

enum um_status um_diagnosis_fit_effects(struct um_context *context,
                                        struct um_sensitivity_forward *forward,
                                        const struct um_model_addition *wanted, size_t nwanted,
                                        const struct um_diagnosis_options *options,
                                        struct um_diagnosis **out)
{
  enum um_status status;
  const struct um_sensitivity_candidates_options these = {.wanted = wanted, .nwanted = nwanted};
  struct um_sensitivity_candidates *candidates = NULL;
  struct um_diagnosis_work work = {0};
  struct um_diagnosis_state state = {0};
  struct um_diagnosis *d = NULL;
  *out = NULL;
  UM_CHECK(um_sensitivity_candidates_create(context, forward, NULL, 0, &these, &candidates));
  UM_CHECK(um_diagnosis_begin(context, forward, candidates, options, &work, &d));
  UM_CHECK(um_diagnosis_baseline(context, &work, &state, d));
  UM_CHECK(um_diagnosis_add_wanted(context, &work, wanted, nwanted, &state));
  UM_CHECK(weigh(context, &work, &state, d));
  UM_CHECK(um_diagnosis_keep_end(context, &work, &state, d));
  put_as_wanted(wanted, d);
  UM_CHECK(um_diagnosis_scatter_describe(context, &work, &state, d));
  UM_CHECK(um_diagnosis_fitted_list(context, &state, d));
  UM_CHECK(um_diagnosis_ties_of_fit(context, &state, d));
  UM_CHECK(um_diagnosis_posterior_draw(context, &work, &state, d));
  for (size_t h = 0; h < UM_HALVES; h++) d->half[h] = NAN;
  d->probability =
      (struct um_diagnosis_probability){NAN, NAN, NAN, NAN}; /* nothing else was asked */
  d->verdict = um_diagnosis_judge(&state, d);
  UM_CHECK(um_diagnosis_summary_write(context, d, &d->summary));
  *out = d;
  d = NULL;
done:
  um_diagnosis_end(context, &work);
  um_diagnosis_state_release(context, &state);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  return status;
}
