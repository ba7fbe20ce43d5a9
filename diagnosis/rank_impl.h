/* Candidates by what the residual says of them. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_RANK_IMPL_H
#define UMBRA_DIAGNOSIS_RANK_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* Test all candidates on the residual of the state; alternative: [count of candidates], by their
 * predicted reduction, falling; nalternative: those that are sensitive. */
enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_alternative *alternative,
                                 size_t *nalternative);
/* Mark who cannot be told from the winner, which is alternative[0]; signal: [nobservation] whitened
 * change that the winner made. */
enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step);

#endif
