/* Effects no longer needed. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_BACKWARD_IMPL_H
#define UMBRA_DIAGNOSIS_BACKWARD_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* Take out effects that are no longer needed; marks their steps. */
enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d);

#endif
