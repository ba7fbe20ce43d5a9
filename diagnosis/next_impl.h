/* The next measurement. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_NEXT_IMPL_H
#define UMBRA_DIAGNOSIS_NEXT_IMPL_H

#include "diagnosis/diagnosis.h"
#include "diagnosis/state_impl.h"

/* What would tell the winner of each step with a group from its alternatives, one for each, and
 * the hardest of them, into d. Small steps are looked at where there are no others. */
enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      struct um_diagnosis *d);

#endif
