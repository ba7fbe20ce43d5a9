/* The verdict on a diagnosis, and its words. */
#include <math.h>

#include "diagnosis/diagnose_impl.h"

#define NOT_NOISE 1e-3 /* p below which a residual is not white noise of the stated sigma */
#define BAD_FIT   1.25 /* reduced chi-square above which what was found does not suffice .. */
#define BAD_PART  2.0  /* .. and that of a channel */
#define MOVED     5.0  /* sigmas by which a free nuisance has taken up something */

const char *um_diagnosis_verdict_name(enum um_diagnosis_verdict verdict)
{
  static const char *const name[] = {"complete", "found", "not_identifiable", "unexplained"};
  return name[verdict];
}

/* A free nuisance that moved far took up something: a calibration, or an effect that resembles it.
 */
static bool nuisance_took_it(const struct um_diagnosis_state *state)
{
  for (size_t b = 0, k = 0; b < state->nnuisance; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++)
      if (isinf(state->block[b].prior_sigma[p]) &&
          fabs(state->fit->x[k] - state->block[b].prior_mean[p]) > MOVED * state->fit->sigma[k])
        return true;
  return false;
}

bool um_diagnosis_is_noise(const struct um_diagnosis_whiteness *w)
{
  return w->p_chi2 > NOT_NOISE && !(w->p_white < NOT_NOISE) && !(w->p_worst < NOT_NOISE);
}

bool um_diagnosis_has_group(const struct um_diagnosis_step *step)
{
  if (step->removed || step->by_prior) return false;
  for (size_t i = 1; i < step->nrival; i++)
    if (step->rival[i].indistinguishable) return true;
  return false;
}

enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             const struct um_diagnosis *d)
{
  bool noise = um_diagnosis_is_noise(&d->final_whiteness);
  if (d->naddition == 0) {
    if (!noise) return UM_VERDICT_UNEXPLAINED;
    return nuisance_took_it(state) ? UM_VERDICT_NOT_IDENTIFIABLE : UM_VERDICT_COMPLETE;
  }
  if (!noise && (d->chi2_reduced_after > BAD_FIT || d->final_whiteness.worst > BAD_PART))
    return UM_VERDICT_UNEXPLAINED;
  for (size_t s = 0; s < d->nstep; s++)
    if (um_diagnosis_has_group(&d->step[s])) return UM_VERDICT_NOT_IDENTIFIABLE;
  return UM_VERDICT_FOUND;
}
