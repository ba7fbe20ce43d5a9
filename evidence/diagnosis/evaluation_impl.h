/* The model as a fit asks for it. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_EVALUATION_IMPL_H
#define UMBRA_DIAGNOSIS_EVALUATION_IMPL_H

#include "evidence/diagnosis/state_impl.h"

struct um_diagnosis_evaluation {
  const struct um_diagnosis_work *work;
  const struct um_diagnosis_state *state;
  struct um_model_addition *addition; /* [nblock] room for one evaluation */
};

/* Additions [nblock] of a state at x [nparameter], by transformed parameters. */
void um_diagnosis_additions_at(const struct um_diagnosis_state *state, const double *x,
                               struct um_model_addition *addition);
/* As a um_inference_fit_problem wants them; user: a um_diagnosis_evaluation. Several are computed
 * by as many processes as the context has threads. */
enum um_status um_diagnosis_evaluate(struct um_context *context, void *user, const double *x,
                                     double *value);
enum um_status um_diagnosis_evaluate_all(struct um_context *context, void *user, size_t n,
                                         const double *x, double *value);

#endif
