/* Pairs of effects in place of others. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H
#define UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H

#include "diagnosis/state_impl.h"

/* Two effects may explain together what the best single one only resembles: try pairs in place of
 * the effect added last and one before it; the better pair stays. */
enum um_status um_diagnosis_pair_swap(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

#endif
