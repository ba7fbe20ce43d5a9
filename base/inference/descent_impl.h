/* A descent: its state, derivatives, steps. Private to base/inference/. */
#ifndef UMBRA_INFERENCE_DESCENT_IMPL_H
#define UMBRA_INFERENCE_DESCENT_IMPL_H

#include "base/inference/fit_problem.h"

/* Where a fit stands. Residuals r = C^-1/2 (measured - value) / sigma, C the noise of the problem,
 * Jacobian C^-1/2 d(value / sigma)/dx. */
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

/* The model at x_trial. happened: false where it refuses (UM_ERR_REFUSED, UM_ERR_NUMERIC, a value
 * that is not finite); its message is then cleared. */
enum um_status um_inference_descent_try(struct um_context *context,
                                        struct um_inference_descent *descent, bool *happened);
/* Jacobian by differences at x. */
enum um_status um_inference_descent_differences(struct um_context *context,
                                                struct um_inference_descent *descent);
/* Broyden's update for the step from x to x_trial. */
void um_inference_descent_update(struct um_inference_descent *descent);
/* Whether the Jacobian as it was made still predicts the residuals at x. */
bool um_inference_descent_jacobian_is_valid(struct um_inference_descent *descent);

/* From the problem's start. Errors of evaluate there are passed on. The caller releases what was
 * begun (um_inference_descent_release), after an error too. */
enum um_status um_inference_descent_begin(struct um_context *context,
                                          const struct um_inference_fit_problem *problem,
                                          struct um_inference_descent *out);
/* To the minimum, or as far as iterations_max reach. */
enum um_status um_inference_descent_run(struct um_context *context,
                                        struct um_inference_descent *descent);

#endif
