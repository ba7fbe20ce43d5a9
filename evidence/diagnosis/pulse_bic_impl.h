/* BIC of a pulse of heat. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_PULSE_BIC_IMPL_H
#define UMBRA_DIAGNOSIS_PULSE_BIC_IMPL_H

#include "base/inference/fit.h"
#include "evidence/missing_heat/unexplained.h"

/* BIC of a fitted state with the best pulse of heat added. */
double um_diagnosis_pulse_bic(const struct um_missing_heat_unexplained *heat,
                              const struct um_inference_fit *fit);

#endif
