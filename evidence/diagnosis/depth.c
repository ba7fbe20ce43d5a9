/* How far a search through white noise should have gone, were the rest a discrepancy. What is left
 * after k of its effects is judged with the noise that it has the largest likelihood with:
 *
 *   BIC_k = worth + p_k ln n + 2 ln C(m, k),
 *
 * with p parameters, and what it costs that k effects were chosen among the m that were tested
 * (extended BIC of Chen & Chen 2008, Biometrika 95:759). */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

static double of_choice(const struct um_diagnosis *d, size_t effects)
{
  double k = (double)effects, n = fmax((double)um_diagnosis_tested(d), k);
  return 2.0 * (lgamma(n + 1.0) - lgamma(k + 1.0) - lgamma(n - k + 1.0));
}

/* What is left beside model values [nobservation], over sigma. */
static void leave(const struct um_sensitivity_observations *o, const double *value, double *out)
{
  for (size_t j = 0; j < o->count; j++) out[j] = (o->measured[j] - value[j]) / o->sigma[j];
}

enum um_status um_diagnosis_depth_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       const struct um_diagnosis *d, double *residual, bool *whole)
{
  enum um_status status = UM_OK;
  const struct um_inference_noise_family *family = &work->discrepancy.family;
  size_t n = family->nobservation, parameters = 0, effects = 0;
  double *left = NULL, least;
  for (size_t b = 0; b < state->nnuisance; b++) parameters += state->block[b].nfree;
  UM_TRY(um_diagnosis_noise_bic(context, family, NULL, state->fit, &least));
  least += of_choice(d, d->naddition);
  *whole = true;
  memcpy(residual, state->fit->residual, n * sizeof *residual);
  UM_CHECK(um_core_allocate(context, n, sizeof *left, &left));
  for (size_t s = 0; s <= d->nstep && effects < d->naddition; s++) {
    struct um_inference_noise own = {0};
    leave(&work->forward->observations, s == 0 ? d->value_before : d->step[s - 1].value, left);
    UM_CHECK(um_inference_noise_estimate(context, family, left, NULL, &own));
    double bic = own.worth + (double)parameters * log((double)n) + of_choice(d, effects);
    um_inference_noise_release(context, &own);
    if (bic < least) {
      least = bic;
      *whole = false;
      memcpy(residual, left, n * sizeof *residual);
    }
    if (s == d->nstep || d->step[s].removed) continue;
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[d->step[s].candidate];
    parameters += c->is_switch ? 0 : c->ncolumn + c->nunidentified;
    parameters += um_diagnosis_phase_is_free(c, &d->step[s].addition);
    effects++;
  }
done:
  um_core_free(context, left);
  return status;
}
