/* Pairs of effects that replace two others. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H
#define UMBRA_DIAGNOSIS_PAIR_SWAP_IMPL_H

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"

struct um_diagnosis_pair {
  size_t candidate[2];
  double worth; /* chi-square that both explain, less ln n per column */
};
/* The best pairs by the linear model, the best first. Two variants of one effect on one target,
 * such as the two discs of the Sun, are no pair. */
enum um_status um_diagnosis_pairs_find(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_pair best[UM_DIAGNOSIS_PAIRS],
                                       size_t *count);
/* Try pairs instead of the effect that was added last and each one before it. A better pair
 * replaces them in the state. */
enum um_status um_diagnosis_pair_swap(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state);

#endif
