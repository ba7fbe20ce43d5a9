/* Along what a discrepancy of the model may go. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DISCREPANCY_IMPL_H
#define UMBRA_DIAGNOSIS_DISCREPANCY_IMPL_H

#include "base/inference/noise.h"
#include "evidence/sensitivity/forward.h"

#define UM_DIAGNOSIS_KINDS_MAX 12

/* Correlations of the observations: along time over several scales, the phase of the orbit, the
 * aspect of the body. UM_ERR_MEMORY. The caller releases. */
struct um_diagnosis_discrepancy {
  struct um_inference_noise_family family;
  double *usual; /* [nchannel] of the family */
  struct um_inference_correlation *kind[UM_DIAGNOSIS_KINDS_MAX];
};
enum um_status um_diagnosis_discrepancy_create(struct um_context *context,
                                               const struct um_sensitivity_forward *forward,
                                               struct um_diagnosis_discrepancy *out);
void um_diagnosis_discrepancy_release(struct um_context *context,
                                      struct um_diagnosis_discrepancy *discrepancy);

#endif
