/* Nonlinear least squares with priors and bounds for models that cost seconds, on GSL's linear
 * algebra; what its result says of the model: uncertainty, BIC, rows held out. Knows rows and
 * parameters, not what they are. */
#ifndef UMBRA_DIAGNOSIS_FIT_H
#define UMBRA_DIAGNOSIS_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/context.h"

struct um_diagnosis_fit_parameter {
  double start, minimum, maximum;
  double prior_mean, prior_sigma; /* sigma INFINITY: none */
  double step;                    /* of differences, > 0, and scale of the parameter */
};

struct um_diagnosis_fit_problem {
  size_t nrow, nparameter;                            /* nparameter may be 0: the model as it is */
  const double *measured;                             /* [nrow] */
  const double *sigma;                                /* [nrow] > 0 */
  const struct um_diagnosis_fit_parameter *parameter; /* [nparameter] */
  /* model values [nrow] at x [nparameter], always within the bounds. UM_ERR_INPUT, UM_ERR_NUMERIC
   * or a value that is not finite: the model refuses this x, which is an error at the start and a
   * shorter step elsewhere */
  enum um_status (*evaluate)(struct um_context *context, void *user, const double *x,
                             double *value);
  void *user;
  /* [nparameter][nrow] d(value)/d(parameter) at the start, or NULL: differences. A Jacobian that is
   * handed in is used, with secant updates, until two steps in a row fail, one gains less than a
   * quarter of what it should, or the solution lies where it no longer holds (5 % of the change of
   * the rows missed, or more bias by it than is enough); then it is made anew by differences. */
  const double *jacobian;
  /* [nrow] model values at the start, or NULL */
  const double *value;
  size_t iterations_max; /* 0: 20 */
  /* Expected decrease of chi-square that is not worth an evaluation, per reduced chi-square where
   * that is above 1; 0: 0.01, a tenth of a sigma. */
  double enough;
  /* Chi-square, the priors' with it, that the fit has to come below to be of use; 0: any is. It is
   * given up, as not converged, when after two steps four times what it promises does not. */
  double beaten;
};

struct um_diagnosis_fit {
  size_t nrow, nparameter, iterations, evaluations;
  /* the next step lowers chi-square by less than is enough, or by less than ten times that, lost in
   * noise of the model. false: iterations_max, or steps that fail or crawl */
  bool converged;
  /* [nparameter]; sigma from the curvature with priors, those at a bound held there; NaN at a
   * bound, INFINITY where rows and priors do not determine it */
  double *x, *sigma;
  double *covariance; /* [nparameter][nparameter]; 0 where sigma is no number */
  bool *at_bound;     /* [nparameter] */
  double *value;      /* [nrow] model at x */
  double *residual;   /* [nrow] (measured - value) / sigma */
  double *jacobian;   /* [nparameter][nrow] d(value)/d(x) / sigma, at or near x */
  double chi2;        /* of the rows */
  double chi2_prior;  /* of the priors */
  double bic;         /* chi2 + chi2_prior + nparameter ln nrow */
};

/* UM_ERR_INPUT: more parameters without prior than rows, a start outside its bounds, a sigma or a
 * step that is not above 0. Errors of evaluate are passed on, as said above. Agrees with NIST's
 * certified problems to 6 digits (tests/diagnosis/fit.c). The caller destroys. */
enum um_status um_diagnosis_fit_create(struct um_context *context,
                                       const struct um_diagnosis_fit_problem *problem,
                                       struct um_diagnosis_fit **out);
void um_diagnosis_fit_destroy(struct um_context *context, struct um_diagnosis_fit **fit);

/* Chi-square of rows that were not used: for every fold the parameters are fitted anew without it
 * (one Gauss-Newton step from the solution by its Jacobian, no model is computed) and its rows
 * predicted. A parameter that only these rows determine goes back to its start. fold: [nrow] below
 * nfold; out: sum over the folds. Compare with the same of a rival or of the model without
 * parameters (its chi2). UM_ERR_MEMORY, UM_ERR_LIBRARY. */
enum um_status um_diagnosis_fit_held_out(struct um_context *context,
                                         const struct um_diagnosis_fit_problem *problem,
                                         const struct um_diagnosis_fit *fit, const size_t *fold,
                                         size_t nfold, double *out);

#endif
