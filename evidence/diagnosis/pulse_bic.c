/* A pulse of heat has a place, a start, a stop and a power: with the k parameters of the state it
 * stands beside,
 *
 *   BIC = chi2 + chi2_prior + (k + 4) ln n        (Schwarz 1978, Ann. Stat. 6:461) */
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>

double um_diagnosis_pulse_bic(const struct um_missing_heat_unexplained *heat,
                              const struct um_inference_fit *fit)
{
  return heat->chi2_after + fit->chi2_prior +
         ((double)fit->nparameter + UM_DIAGNOSIS_OF_A_PULSE) * log((double)fit->nobservation);
}
