/* Why an effect that no other comes near is not certain all the same. */
#include "evidence/diagnosis/doubt.h"

#include <math.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"

/* Factor on sigmas where observations scatter more than stated: the root of reduced chi-square.
 * Where they scatter less it is 1, and nothing is made more certain. */
static double scatter(const struct um_diagnosis *d)
{
  return d->weighed ? 1.0 : sqrt(fmax(1.0, d->chi2_reduced_after));
}

/* Whether every tested parameter of the effect is near the value where it does nothing. Sigma is
 * marginal: everything else may move. A switch has no such value. A parameter at the end of its
 * range has no sigma. */
static bool is_near_nothing(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  const struct um_sensitivity_candidate *c = &d->candidates->candidate[step->candidate];
  if (c->is_switch) return false;
  for (size_t k = 0; k < c->ncolumn; k++) {
    size_t p = c->parameter[k];
    const struct um_effect_parameter *of = &c->effect->parameters[p];
    double value = step->addition.value[p];
    double away = um_effect_transformed(of, value) - um_effect_transformed(of, c->null_value[p]);
    double sigma = scatter(d) * step->sigma[p] / um_effect_transformed_slope(of, value);
    if (isnan(sigma) ? away != 0.0 : fabs(away) > UM_DIAGNOSIS_SIGMAS * sigma) return false;
  }
  return c->ncolumn > 0;
}

/* Whether a discrepancy alone explains nearly as much: the odds of the effect against a model
 * without it, both with the noise of their own residual, and one of all candidates by its prior. */
static bool is_near_discrepancy(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  if (!d->weighed) return false;
  double one = UM_DIAGNOSIS_PRIOR_ONE / (double)um_diagnosis_tested(d);
  return log(one / UM_DIAGNOSIS_PRIOR_NOTHING) - 0.5 * step->delta_bic <
         log(UM_DIAGNOSIS_CERTAIN / (1.0 - UM_DIAGNOSIS_CERTAIN));
}

/* Whether most changes of the measurements, the priors or the noise alter what is named. */
static bool hangs_on_little(const struct um_diagnosis *d, const struct um_diagnosis_step *step)
{
  const struct um_diagnosis_sceptic *s = &d->sceptic;
  return s->asked && step == &d->step[s->step] && 2 * s->flips > s->variations;
}

const char *um_diagnosis_doubt_of(const struct um_diagnosis *d,
                                  const struct um_diagnosis_step *step)
{
  if (d->candidates == NULL) return NULL;
  if (is_near_nothing(d, step)) return "its value is within two sigmas of nothing";
  if (is_near_discrepancy(d, step)) return "an error of the model would explain nearly as much";
  if (hangs_on_little(d, step))
    return "most small changes of data, priors or noise would alter what is named";
  return NULL;
}
