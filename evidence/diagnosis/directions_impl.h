/* Candidates and nuisances as whitened directions. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DIRECTIONS_IMPL_H
#define UMBRA_DIAGNOSIS_DIRECTIONS_IMPL_H

#include "evidence/diagnosis/state_impl.h"

/* Directions of the candidates, and the memory they point into. */
struct um_diagnosis_directions {
  struct um_inference_direction *direction; /* [count of candidates] */
  double *column;                           /* whitened signatures, one after another */
  double *bound;                            /* [3][columns] lowest, highest step, prior sigma */
  struct um_inference_nuisance nuisance;
  double *nuisance_sigma; /* [nparameter of the state] */
};

enum um_status um_diagnosis_directions_make(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_diagnosis_directions *d);
void um_diagnosis_directions_release(struct um_context *context, struct um_diagnosis_directions *d);
/* The unit of a column of a candidate [transformed]: the step of its difference. So the length of a
 * column is the effect of a step, whatever the unit of the parameter. */
double um_diagnosis_unit(const struct um_sensitivity_candidate *c, size_t k);
/* Residual [n] with the parameters of the state at the means of their priors:
 *   r0 = r + sum_k J_k (x_k - m_k), so that the prior of a nuisance is a pseudo-row of value 0. */
void um_diagnosis_residual_at_means(const struct um_diagnosis_state *state, size_t n, double *out);
/* Two variants of one effect on one target, as the two discs of the Sun. */
bool um_diagnosis_is_same_effect(const struct um_sensitivity_candidate *a,
                                 const struct um_sensitivity_candidate *b);
/* An effect on a target that is fitted already. */
bool um_diagnosis_is_taken(const struct um_diagnosis_state *state,
                           const struct um_sensitivity_candidate *c);

#endif
