/* What a fit is asked: observations, parameters, a model. */
#ifndef UMBRA_INFERENCE_FIT_PROBLEM_H
#define UMBRA_INFERENCE_FIT_PROBLEM_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"
#include "base/inference/noise.h"

struct um_inference_fit_parameter {
  double start, minimum, maximum;
  double prior_mean, prior_sigma; /* sigma INFINITY: none */
  double step;                    /* of differences, > 0, and scale of the parameter */
};

struct um_inference_fit_problem {
  size_t nobservation, nparameter;                    /* nparameter may be 0: the model as it is */
  const double *measured;                             /* [nobservation] */
  const double *sigma;                                /* [nobservation] > 0 */
  const struct um_inference_fit_parameter *parameter; /* [nparameter] */
  /* model values [nobservation] at x [nparameter], always within the bounds. UM_ERR_REFUSED,
   * UM_ERR_NUMERIC or a value that is not finite: the model refuses this x, which is an error at
   * the start and a shorter step elsewhere */
  enum um_status (*evaluate)(struct um_context *context, void *user, const double *x,
                             double *value);
  /* the same at several x [n][nparameter], into value [n][nobservation]: for who computes them at
   * once. A row that the model refuses begins with NaN. NULL: one after another, with the same
   * answers */
  enum um_status (*evaluate_all)(struct um_context *context, void *user, size_t n, const double *x,
                                 double *value);
  void *user;
  /* [nparameter][nobservation] d(value)/d(parameter) at the start, or NULL: differences. A Jacobian
   * that is handed in is used, with secant updates, until two steps in succession fail, one
   * gains less than a quarter of what it should, or the solution lies where it no longer holds (5 %
   * of the change of the observations missed, or more bias by it than the tolerance); then it is
   * made anew by differences. */
  const double *jacobian;
  /* [nobservation] model values at the start, or NULL */
  const double *value;
  size_t iterations_max; /* 0: 20 */
  /* Expected decrease of chi-square that is not worth an evaluation, per reduced chi-square where
   * that is above 1; 0: 0.01, a tenth of a sigma. */
  double tolerance;
  /* prunes: the fit is of use only below this chi-square, that of the priors with it; one of 0 or
   * less is never reached. The fit ends, as not converged, when after two steps four times its
   * predicted reduction would not bring it there. */
  bool prunes;
  bool sure; /* observations are known to be linear in what is free: it prunes before the first
                step, by UM_INFERENCE_PRUNE_SURE times the reduction */
  double prune_above;
  /* NULL: residuals over sigma are white noise. Else chi-square is r'C^-1 r of it; borrowed */
  struct um_inference_noise *noise;
};

#endif
