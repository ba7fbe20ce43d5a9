/* The verdict. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_VERDICT_IMPL_H
#define UMBRA_DIAGNOSIS_VERDICT_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* White noise of the stated sigma. */
bool um_diagnosis_is_noise(const struct um_inference_whiteness *whiteness);
/* Alternatives that the data cannot tell from the winner of a step that stayed, priors apart. */
bool um_diagnosis_has_group(const struct um_diagnosis_step *step);
/* Of a diagnosis whose end is kept; state: the nuisances as they were fitted. Notes whether what is
 * left was allowed for. */
enum um_diagnosis_verdict um_diagnosis_judge(const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d);
/* How well the effect of each step is known, after the verdict. */
void um_diagnosis_confidence_assign(struct um_diagnosis *d);

#endif
