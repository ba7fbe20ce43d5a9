/* Non-linear fits of candidates. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_ALTERNATIVES_IMPL_H
#define UMBRA_DIAGNOSIS_ALTERNATIVES_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Fit the alternatives of a step in their order, until the scores of those left are too low; sort
 * them by BIC. best: the state with the best of those fitted here; unchanged where none was. */
enum um_status um_diagnosis_fit_alternatives(struct um_context *context,
                                             const struct um_diagnosis_work *work,
                                             const struct um_diagnosis_state *state,
                                             struct um_diagnosis_step *step,
                                             struct um_diagnosis_state *best);

#endif
