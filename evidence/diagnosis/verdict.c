/* The verdict on a diagnosis. */
#include <math.h>

#include "evidence/diagnosis/doubt.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* Whether a free nuisance moved far. Then it has absorbed something: a calibration, or an effect
 * that resembles it. */
static bool nuisance_took_it(const struct um_diagnosis_state *state)
{
  for (size_t b = 0, k = 0; b < state->nnuisance; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++)
      if (isinf(state->block[b].prior_sigma[p]) &&
          fabs(state->fit->x[k] - state->block[b].prior_mean[p]) >
              UM_DIAGNOSIS_MOVED * state->fit->sigma[k])
        return true;
  return false;
}

bool um_diagnosis_is_noise(const struct um_inference_whiteness *w)
{
  return w->p_chi2 > UM_DIAGNOSIS_NOT_NOISE && !(w->p_white < UM_DIAGNOSIS_NOT_NOISE) &&
         !(w->p_worst < UM_DIAGNOSIS_NOT_NOISE);
}

bool um_diagnosis_has_group(const struct um_diagnosis_step *step)
{
  if (step->removed || step->by_prior) return false;
  for (size_t i = 1; i < step->nalternative; i++)
    if (step->alternative[i].indistinguishable || step->alternative[i].not_tried) return true;
  return false;
}

enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d)
{
  bool noise = um_diagnosis_is_noise(&d->final_whiteness);
  double reduced =
      d->weighed ? d->final_whiteness.chi2 / d->final_whiteness.dof : d->chi2_reduced_after;
  if (um_diagnosis_discrepancy_is_large(d)) return UM_VERDICT_UNEXPLAINED;
  if (d->naddition == 0) {
    if (!noise) return UM_VERDICT_UNEXPLAINED;
    return nuisance_took_it(state) ? UM_VERDICT_NOT_IDENTIFIABLE : UM_VERDICT_COMPLETE;
  }
  if (!noise &&
      (reduced > UM_DIAGNOSIS_BAD_FIT || d->final_whiteness.worst > UM_DIAGNOSIS_BAD_PART))
    return UM_VERDICT_UNEXPLAINED;
  d->allowance = !noise;
  for (size_t s = 0; s < d->nstep; s++)
    if (um_diagnosis_has_group(&d->step[s]) ||
        (!d->step[s].removed && um_diagnosis_doubt_of(d, &d->step[s]) != NULL))
      return UM_VERDICT_NOT_IDENTIFIABLE;
  return UM_VERDICT_FOUND;
}

/* Whether alternatives are within the evidence of the winner. scale: differences of BIC are too
 * large by this factor, where observations scatter more than stated. */
static bool is_matched(const struct um_diagnosis_step *step, double scale)
{
  if (um_diagnosis_has_group(step)) return true;
  if (step->nalternative == 0 || step->by_prior) return false;
  for (size_t i = 1; i < step->nalternative; i++) {
    const struct um_diagnosis_alternative *r = &step->alternative[i];
    if (!r->fitted || r->same_effect || r->implausible) continue;
    if (r->bic - step->alternative[0].bic < scale * UM_DIAGNOSIS_EVIDENCE) return true;
  }
  return false;
}

void um_diagnosis_confidence_assign(struct um_diagnosis *d)
{
  double scale = 1.0;
  if (d->verdict == UM_VERDICT_UNEXPLAINED) scale = fmax(1.0, d->chi2_reduced_after);
  for (size_t s = 0; s < d->nstep; s++) {
    struct um_diagnosis_step *step = &d->step[s];
    if (!is_matched(step, scale))
      step->confidence =
          um_diagnosis_doubt_of(d, step) != NULL ? UM_CONFIDENCE_UNCERTAIN : UM_CONFIDENCE_CERTAIN;
    else if (-step->delta_bic < scale * UM_DIAGNOSIS_SMALL)
      step->confidence = UM_CONFIDENCE_SMALL;
    else
      step->confidence = UM_CONFIDENCE_ONE_OF_GROUP;
  }
}
