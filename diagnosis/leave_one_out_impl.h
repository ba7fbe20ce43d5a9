/* Each effect judged beside the others. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_LEAVE_ONE_OUT_IMPL_H
#define UMBRA_DIAGNOSIS_LEAVE_ONE_OUT_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* Steps anew, each effect as the last one beside the others that stayed: its alternatives, its
 * group, its p; an effect that an alternative betters is replaced. In falling order of what they
 * explain. */
enum um_status um_diagnosis_leave_one_out(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          struct um_diagnosis_state *state, struct um_diagnosis *d);
/* A candidate leads the alternatives of a step, the others keep their order. false: it is none. */
bool um_diagnosis_put_first(struct um_diagnosis_step *step, size_t candidate);

#endif
