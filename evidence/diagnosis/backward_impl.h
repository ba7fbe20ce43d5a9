/* Effects no longer needed. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_BACKWARD_IMPL_H
#define UMBRA_DIAGNOSIS_BACKWARD_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* Remove effects that are no longer needed, and mark their steps as removed. */
enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);

#endif
