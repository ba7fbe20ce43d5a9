/* From a scenario and measurements to the effect that is missing (docs/diagnosis.md). */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSE_H
#define UMBRA_DIAGNOSIS_DIAGNOSE_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/options.h"

/* candidates: made once by um_sensitivity_candidates_create without additions, may serve many sets
 * of the same times. UM_ERR_INPUT: fewer observations than free parameters, a nuisance per
 * observation. Progress is reported. The caller destroys (um_diagnosis_destroy). */
enum um_status um_diagnosis_create(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidates *candidates,
                                   const struct um_diagnosis_options *options,
                                   struct um_diagnosis **out);

/* Only the fit of chosen effects (umbra fit), without tests. value of each: where it starts, NAN:
 * not said. An effect that says none is added as a diagnosis adds it, the one that explains most
 * first; those that say one are fitted from there before. Where what is left is not noise of the
 * stated sigma, the noise is estimated and they are fitted anew with it (weighed, scatter,
 * outlier). UM_ERR_INPUT: an effect that has nothing to fit, as many free parameters as
 * observations. */
enum um_status um_diagnosis_fit_effects(struct um_context *context,
                                        struct um_sensitivity_forward *forward,
                                        const struct um_model_addition *wanted, size_t nwanted,
                                        const struct um_diagnosis_options *options,
                                        struct um_diagnosis **out);

#endif
