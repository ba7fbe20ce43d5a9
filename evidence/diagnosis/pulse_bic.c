/* Heat has a place, a start, a power and what else its shape needs, h numbers in all: with the k
 * parameters of the state it stands beside,
 *
 *   BIC = chi2 + chi2_prior + (k + h) ln n        (Schwarz 1978, Ann. Stat. 6:461) */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>

double um_diagnosis_pulse_bic(const struct um_missing_heat_unexplained *heat,
                              const struct um_inference_fit *fit)
{
  size_t of_heat = heat->nheat > 0 ? heat->heat[0].nparameter : 0;
  return heat->chi2_after + fit->chi2_prior +
         (double)(fit->nparameter + of_heat) * log((double)fit->nobservation);
}
