/* Nonlinear least squares with priors and bounds for models that cost seconds, on GSL's linear
 * algebra; what its result says of the model: uncertainty, BIC, observations held out. Knows
 * observations and parameters, not what they are. */
#ifndef UMBRA_INFERENCE_FIT_H
#define UMBRA_INFERENCE_FIT_H

#include "base/inference/fit_problem.h"

struct um_inference_fit {
  size_t nobservation, nparameter, iterations, evaluations;
  /* the next step lowers chi-square by less than the tolerance, or by less than ten times that,
   * lost in noise of the model. false: iterations_max, or steps that fail or stagnate */
  bool converged;
  /* [nparameter]; sigma from the curvature with priors, those at a bound held there; NaN at a
   * bound, INFINITY where observations and priors do not determine it */
  double *x, *sigma;
  double *covariance; /* [nparameter][nparameter]; 0 where sigma is no number */
  bool *at_bound;     /* [nparameter] */
  double *value;      /* [nobservation] model at x */
  double *residual;   /* [nobservation] (measured - value) / sigma */
  double *jacobian;   /* [nparameter][nobservation] d(value)/d(x) / sigma, at or near x */
  double chi2;        /* of the observations: r'C^-1 r where the problem has a noise */
  double chi2_prior;  /* of the priors */
  double bic;         /* chi2 + chi2_prior + nparameter ln nobservation */
};

/* UM_ERR_INPUT: more parameters without prior than observations, a start outside its bounds, a
 * sigma or a step that is not above 0. Errors of evaluate are passed on, as said above. Agrees with
 * NIST's certified problems to 6 digits (tests/base/inference/fit.c). The caller destroys. */
enum um_status um_inference_fit_create(struct um_context *context,
                                       const struct um_inference_fit_problem *problem,
                                       struct um_inference_fit **out);
void um_inference_fit_destroy(struct um_context *context, struct um_inference_fit **fit);

/* A fit as numbers, for another process of this program: how many one of these sizes takes; into
 * out [packed]; back from there, of the same sizes, UM_ERR_MEMORY, the caller destroys. */
size_t um_inference_fit_packed(size_t nobservation, size_t nparameter);
void um_inference_fit_pack(const struct um_inference_fit *fit, double *out);
enum um_status um_inference_fit_unpack(struct um_context *context, const double *from,
                                       size_t nobservation, size_t nparameter,
                                       struct um_inference_fit **out);

/* Chi-square of observations that were not used: for every fold the parameters are fitted anew
 * without it (one Gauss-Newton step from the solution by its Jacobian, no model is computed) and
 * its observations predicted. A parameter that only these observations determine goes back to its
 * start. fold: [nobservation] below nfold; out: sum over the folds. Compare with the same of an
 * alternative or of the model without parameters (its chi2). UM_ERR_MEMORY, UM_ERR_LIBRARY. */
enum um_status um_inference_fit_held_out(struct um_context *context,
                                         const struct um_inference_fit_problem *problem,
                                         const struct um_inference_fit *fit, const size_t *fold,
                                         size_t nfold, double *out);

#endif
