/* The next measurement. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_NEXT_IMPL_H
#define UMBRA_DIAGNOSIS_NEXT_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/state_impl.h"

/* Fill d->next_of: for each alternative of each step with a group, the observation that would tell
 * it from the winner; and d->next, the hardest of them. Small steps count only where there are no
 * others. */
enum um_status um_diagnosis_next_find(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      struct um_diagnosis *d);

#endif
