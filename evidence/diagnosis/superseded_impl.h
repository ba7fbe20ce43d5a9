/* Effects that were replaced. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_SUPERSEDED_IMPL_H
#define UMBRA_DIAGNOSIS_SUPERSEDED_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Record every step so far, before they are judged anew. */
enum um_status um_diagnosis_superseded_take(struct um_context *context, struct um_diagnosis *d);
/* Keep on record those that are neither in the final state nor in a step. */
void um_diagnosis_superseded_keep(const struct um_diagnosis_state *state, struct um_diagnosis *d);

#endif
