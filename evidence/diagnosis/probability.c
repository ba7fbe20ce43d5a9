/* Probabilities of what the search compared, from their BIC (Kass & Raftery 1995, JASA 90:773: -2
 * ln of the evidence to order 1):
 *
 *   P(h) ~ prior(h) exp(-BIC_h / 2),
 *
 * with a prior for nothing, one for any one effect, shared by the candidates that were tested, and
 * one for any two, shared by their pairs. What the catalogue has not is the scenario as it is, with
 * a discrepancy that is too large to be one, or with a pulse of heat. */
#include <math.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* ln of prior and evidence. */
static double weight(double prior, double bic) { return log(prior) - 0.5 * bic; }

size_t um_diagnosis_tested(const struct um_diagnosis *d)
{
  size_t n = 0;
  for (size_t i = 0; i < d->nranking; i++) n += !d->ranking[i].score.absorbed;
  return n > 0 ? n : 1;
}

/* Shares of the alternatives of a step, and of the scenario without any of them. What is the winner
 * by another name has none of its own. */
static void share(struct um_diagnosis_step *step, double one, double nothing)
{
  if (step->nalternative == 0) return;
  double best = step->alternative[0].bic, without = best - step->delta_bic;
  double sum = nothing * exp(-0.5 * (without - best));
  for (size_t i = 0; i < step->nalternative; i++) {
    struct um_diagnosis_alternative *r = &step->alternative[i];
    r->probability = r->fitted && !r->contains_winner ? one * exp(-0.5 * (r->bic - best)) : 0.0;
    sum += r->probability;
  }
  for (size_t i = 0; i < step->nalternative; i++) step->alternative[i].probability /= sum;
}

/* ln of a sum, given as ln. */
static double add(double a, double b)
{
  double most = fmax(a, b);
  return isinf(most) ? most : most + log(exp(a - most) + exp(b - most));
}

void um_diagnosis_probabilities_assign(const struct um_diagnosis_state *bare,
                                       struct um_diagnosis *d)
{
  double m = (double)um_diagnosis_tested(d), one = UM_DIAGNOSIS_PRIOR_ONE / m;
  double pairs = fmax(1.0, 0.5 * m * (m - 1.0)), single = -INFINITY, several = -INFINITY;
  double none = -INFINITY, nothing = weight(UM_DIAGNOSIS_PRIOR_NOTHING, bare->fit->bic);
  for (size_t s = 0; s < d->nstep; s++) {
    if (d->step[s].removed) continue;
    share(&d->step[s], one, UM_DIAGNOSIS_PRIOR_NOTHING);
    for (size_t i = 0; i < d->step[s].nalternative && d->naddition == 1; i++)
      if (d->step[s].alternative[i].fitted)
        single = add(single, weight(one, d->step[s].alternative[i].bic));
  }
  for (size_t i = 0; i < d->nsuperseded && d->naddition > 1; i++)
    if (d->superseded[i].alone) single = add(single, weight(one, d->superseded[i].bic));
  if (d->naddition > 1) several = weight(UM_DIAGNOSIS_PRIOR_SEVERAL / pairs, d->bic_after);
  if (d->verdict == UM_VERDICT_UNEXPLAINED) {
    double bic = d->naddition > 0 ? d->bic_after : bare->fit->bic;
    if (d->unexplained != NULL && d->unexplained->nheat > 0)
      bic = fmin(bic, um_diagnosis_pulse_bic(d->unexplained, bare->fit));
    /* nothing of what was compared leaves noise */
    none = weight(UM_DIAGNOSIS_PRIOR_NONE, bic);
    nothing = single = several = -INFINITY;
  }
  double all = add(add(nothing, single), add(several, none));
  d->probability = (struct um_diagnosis_probability){exp(nothing - all), exp(single - all),
                                                     exp(several - all), exp(none - all)};
}
