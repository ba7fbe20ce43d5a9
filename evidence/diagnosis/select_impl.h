/* One step of forward selection. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_SELECT_IMPL_H
#define UMBRA_DIAGNOSIS_SELECT_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Fill a step from the state before it and the best state after it, with the winner's group. */
enum um_status um_diagnosis_step_fill(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_state *best,
                                      struct um_diagnosis_step *step);
/* One step of forward selection: rank, fit alternatives, add the winner to the state. *added: false
 * when nothing is significant or nothing helps. */
enum um_status um_diagnosis_select(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state, struct um_diagnosis_step *step,
                                   bool *added);

#endif
