/* Heat has a place, a start, a power and what else its shape needs, h numbers in all: with the k
 * parameters of the state it stands beside,
 *
 *   BIC = chi2 + chi2_prior + (k + h) ln n        (Schwarz 1978, Ann. Stat. 6:461)
 *
 * Light has its worth w (missing_light), by a reduced chi-square s that it leaves, at least 1.
 * Where s is the noise of the observations, one more number, -2 ln of their likelihood is
 *
 *   BIC = chi2 / s + n ln s - w + chi2_prior + k ln n,   and ln n where s > 1. */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>

double um_diagnosis_pulse_bic(const struct um_missing_heat_unexplained *heat,
                              const struct um_inference_fit *fit)
{
  size_t of_heat = heat->nheat > 0 ? heat->heat[0].nparameter : 0;
  return heat->chi2_after + fit->chi2_prior +
         (double)(fit->nparameter + of_heat) * log((double)fit->nobservation);
}

double um_diagnosis_light_bic(const struct um_missing_light *light,
                              const struct um_inference_fit *fit)
{
  double n = (double)fit->nobservation, k = (double)fit->nparameter + (light->scale > 1.0);
  return light->chi2_before / light->scale + n * log(light->scale) - light->worth +
         fit->chi2_prior + k * log(n);
}
