/* Effects no longer needed. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_BACKWARD_IMPL_H
#define UMBRA_DIAGNOSIS_BACKWARD_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Remove effects that are no longer needed, and mark their steps as removed. */
enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);

#endif
