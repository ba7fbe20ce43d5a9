/* Fits of effects whose chi-square is not smooth. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_NON_SMOOTH_IMPL_H
#define UMBRA_DIAGNOSIS_NON_SMOOTH_IMPL_H

#include "evidence/diagnosis/state_impl.h"

/* Start values of block b of a state, a candidate with parameters unidentified under the null that
 * was added to the fitted state `before`: the best of a small scan. */
enum um_status um_diagnosis_start(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *before,
                                  struct um_diagnosis_state *state, size_t b);

/* Block b of a fitted state, with parameters unidentified under the null, searched for better
 * values beyond the next discontinuity of chi-square; the state, fitted anew, is the better one of
 * both. */
enum um_status um_diagnosis_simplex_refine(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           struct um_diagnosis_state *state, size_t b);

#endif
