/* Fits of a state with candidates added, many at once. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_TRIALS_IMPL_H
#define UMBRA_DIAGNOSIS_TRIALS_IMPL_H

#include "evidence/diagnosis/state_impl.h"

/* A copy of the state with candidates added at their null values, fitted together. The fit is
 * pruned where its BIC will not come below `prune_above` (INFINITY: never). UM_ERR_REFUSED,
 * UM_ERR_NUMERIC: an effect refuses such values. */
enum um_status um_diagnosis_with(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, const size_t *candidate,
                                 size_t ncandidate, double prune_above,
                                 struct um_diagnosis_state *out);

/* The same, one of many. */
#define UM_DIAGNOSIS_TRIAL_CANDIDATES 2

struct um_diagnosis_trial {
  size_t candidate[UM_DIAGNOSIS_TRIAL_CANDIDATES], ncandidate;
  double prune_above; /* the fit is pruned where its BIC will not come below; INFINITY: never */
  double lead;        /* with parameters unidentified under the null: refined by a simplex where its
                         BIC is below; -INFINITY: never */
  bool refused;       /* out: an effect refuses such values */
  struct um_diagnosis_state state; /* out: with its fit, where it is not refused */
};

/* Fit every trial, by as many processes as the context has threads: the answers do not depend on
 * how many. The progress names the first of them; each is a step. The caller releases the states,
 * after a failure too. */
enum um_status um_diagnosis_trials_fit(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_trial *trial, size_t n);
void um_diagnosis_trials_release(struct um_context *context, struct um_diagnosis_trial *trial,
                                 size_t n);

#endif
