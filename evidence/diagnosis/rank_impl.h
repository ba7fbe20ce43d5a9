/* Ranking of candidates. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_RANK_IMPL_H
#define UMBRA_DIAGNOSIS_RANK_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Score test of all candidates on the residual of the state. alternative: [count of candidates],
 * filled with the *nalternative that observations change with, the largest predicted reduction
 * first. */
enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_alternative *alternative,
                                 size_t *nalternative);
/* Mark the alternatives that cannot be told from the winner, which is alternative[0]. signal:
 * [nobservation] whitened change of the model values by the winner. */
enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step);

#endif
