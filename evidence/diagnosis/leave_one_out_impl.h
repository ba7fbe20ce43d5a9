/* Each effect judged beside the others. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_LEAVE_ONE_OUT_IMPL_H
#define UMBRA_DIAGNOSIS_LEAVE_ONE_OUT_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Make the steps anew, each for one effect added last to the others: its alternatives, its group,
 * its p. An effect is replaced where an alternative does better. Steps are sorted by what their
 * effects explain, falling. */
enum um_status um_diagnosis_leave_one_out(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          struct um_diagnosis_state *state, struct um_diagnosis *d);
/* Put a candidate first among the alternatives of a step; the others keep their order. false: it is
 * not among them. */
bool um_diagnosis_put_first(struct um_diagnosis_step *step, size_t candidate);

#endif
