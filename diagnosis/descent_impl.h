/* The iteration of a fit. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DESCENT_IMPL_H
#define UMBRA_DIAGNOSIS_DESCENT_IMPL_H

#include "diagnosis/fit.h"

/* Where a fit stands. Residuals r = (measured - value) / sigma, Jacobian d(value / sigma)/dx. */
struct um_diagnosis_descent {
  const struct um_diagnosis_fit_problem *problem;
  size_t n, nrow;
  double *x, *value, *r;                   /* [n], [nrow], [nrow] accepted */
  double *x_trial, *value_trial, *r_trial; /* the same of the trial */
  double *jacobian;                        /* [n][nrow] with its updates */
  /* the Jacobian as it was made, where, and with which residuals */
  double *base_jacobian, *base_x, *base_r;
  bool fresh;                    /* the Jacobian was made by differences at x */
  size_t updates;                /* of the Jacobian since it was made */
  double chi2, chi2_prior;       /* at x */
  double radius;                 /* of the region of trust, in steps of the parameters */
  double *scale, *pull, *width;  /* [n] of the linear problem at x */
  double *lower, *upper, *u, *v; /* [n] */
  size_t failed;                 /* steps in a row */
  size_t slow_steps;             /* that gained, of those looked at together .. */
  double slow;                   /* .. and what they gained */
  size_t evaluations, iterations;
  bool converged;
};

/* From the problem's start. Errors of evaluate there are passed on. The caller releases what was
 * begun, after an error too. */
enum um_status um_diagnosis_descent_begin(struct um_context *context,
                                          const struct um_diagnosis_fit_problem *problem,
                                          struct um_diagnosis_descent *out);
void um_diagnosis_descent_release(struct um_context *context, struct um_diagnosis_descent *descent);
/* To the minimum, or as far as iterations_max reach. */
enum um_status um_diagnosis_descent_run(struct um_context *context,
                                        struct um_diagnosis_descent *descent);

/* Chi-square that is not worth a run. */
double um_diagnosis_descent_enough(const struct um_diagnosis_descent *descent);
/* The model at x_trial. happened: false where it refuses (UM_ERR_INPUT, UM_ERR_NUMERIC, a value
 * that is not finite); its message is then cleared. */
enum um_status um_diagnosis_descent_try(struct um_context *context,
                                        struct um_diagnosis_descent *descent, bool *happened);
/* Jacobian by differences at x. */
enum um_status um_diagnosis_descent_differences(struct um_context *context,
                                                struct um_diagnosis_descent *descent);
/* Broyden's update for the step from x to x_trial. */
void um_diagnosis_descent_update(struct um_diagnosis_descent *descent);
/* Whether the Jacobian as it was made still predicts the residuals at x. */
bool um_diagnosis_descent_serves(struct um_diagnosis_descent *descent);

#endif
