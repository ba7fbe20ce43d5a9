/* The observations in use, in the linear unit, each with a sigma. */
#ifndef UMBRA_SENSITIVITY_OBSERVATIONS_H
#define UMBRA_SENSITIVITY_OBSERVATIONS_H

#include <stddef.h>

/* Measurements with flag 0, in file order. */
struct um_sensitivity_observations {
  size_t count;
  size_t *row;      /* [count] of the set */
  size_t *channel;  /* [count] of the set's channels */
  double *t;        /* [count] t_tai [s] */
  double *measured; /* [count] linear unit: magnitudes as flux relative to magnitude 0 */
  /* [count] linear unit. stated: of the measurement, or of the scenario's noise model. model: of
   * the model's own sampling, at the scenario as it stands; 0 of temperatures. sigma: both in
   * quadrature, what every residual is weighed by; it stays while effects come and go, so that
   * chi-square is smooth in their parameters. */
  double *sigma, *stated_sigma, *model_sigma;
  double model_share; /* mean of model_sigma^2 / sigma^2 [1] */
};

#endif
