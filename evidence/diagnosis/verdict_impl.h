/* The verdict. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_VERDICT_IMPL_H
#define UMBRA_DIAGNOSIS_VERDICT_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Whether a residual is white noise of the stated sigma. */
bool um_diagnosis_is_noise(const struct um_inference_whiteness *whiteness);
/* Whether a step that was not removed has alternatives that the observations, without priors,
 * cannot tell from its winner. */
bool um_diagnosis_has_group(const struct um_diagnosis_step *step);
/* The verdict, once the final state is kept in d. state: with the fitted nuisances. Sets
 * d->allowance.
 */
enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d);
/* Set the class of confidence of each step, after the verdict. */
void um_diagnosis_confidence_assign(struct um_diagnosis *d);

#endif
