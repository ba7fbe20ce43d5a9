/* Where a fit stands. Private to base/inference/. */
#ifndef UMBRA_INFERENCE_DESCENT_STATE_IMPL_H
#define UMBRA_INFERENCE_DESCENT_STATE_IMPL_H

#include "base/inference/fit_problem.h"

/* Where a fit stands. Residuals r = (measured - value) / sigma, Jacobian d(value / sigma)/dx. */
struct um_inference_descent {
  const struct um_inference_fit_problem *problem;
  size_t n, nobservation;
  double *x, *value, *r;                   /* [n], [nobservation], [nobservation] accepted */
  double *x_trial, *value_trial, *r_trial; /* the same of the trial */
  double *jacobian;                        /* [n][nobservation] with its updates */
  /* the Jacobian as it was made, where, and with which residuals */
  double *base_jacobian, *base_x, *base_r;
  bool fresh;                    /* the Jacobian was made by differences at x */
  size_t updates;                /* of the Jacobian since it was made */
  double chi2, chi2_prior;       /* at x */
  double radius;                 /* of the region of trust, in steps of the parameters */
  double *scale, *pull, *width;  /* [n] of the linear problem at x */
  double *lower, *upper, *u, *v; /* [n] */
  size_t failed;                 /* steps in succession */
  size_t slow_steps;             /* that gained, of those looked at together .. */
  double slow;                   /* .. and what they gained */
  size_t evaluations, iterations;
  bool converged;
};

/* Memory for a problem, whose start is not computed yet. The caller releases it, after an error
 * too.
 */
enum um_status um_inference_descent_reserve(struct um_context *context,
                                            struct um_inference_descent *descent);
void um_inference_descent_release(struct um_context *context, struct um_inference_descent *descent);
/* Chi-square that is not worth a run. */
double um_inference_descent_tolerance(const struct um_inference_descent *descent);
/* Chi-square of the priors at x. */
double um_inference_descent_chi2_prior(const struct um_inference_descent *descent, const double *x);

#endif
