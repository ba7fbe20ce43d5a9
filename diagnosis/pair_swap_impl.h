/* Pairs of effects in place of others. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H
#define UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H

#include "diagnosis/policy.h"
#include "diagnosis/state_impl.h"

struct um_diagnosis_pair {
  size_t candidate[2];
  double worth; /* chi-square that both explain beside the state, less columns * ln n */
};
/* The best pairs by the linear model, falling. Two variants of one effect on one target, as the two
 * discs of the Sun, are no pair. */
enum um_status um_diagnosis_pairs_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS],
                                       size_t *count);
/* Two effects may explain together what the best single one only resembles: try pairs in place of
 * the effect added last and one before it; the better pair stays. */
enum um_status um_diagnosis_pair_swap(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

#endif
