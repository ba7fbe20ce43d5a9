/* Which directions a residual points in: score test with nuisance directions projected out, and
 * which directions cannot be told from each other. Linear statistics of whitened observations
 * (value over sigma); nothing here knows a model. */
#ifndef UMBRA_INFERENCE_SCORE_H
#define UMBRA_INFERENCE_SCORE_H

#include <stdint.h>

#include "base/inference/direction.h"

struct um_inference_score {
  /* chi-square that the direction explains, after the nuisances; 0 against a bound. Where p
   * underflows to 0 it still ranks */
  double statistic;
  double dof;
  double
      p; /* one-sided where a bound is at the null value and ncolumn is 1: above 0.5 against it */
  /* family-wise over all directions that are not absorbed (Sidak with Holm's steps); collinear ones
   * are one test */
  double p_corrected;
  double estimate[8],
      sigma[8]; /* [ncolumn] linear; without prior; NaN when absorbed or collinear */
  double kept;  /* share of a column's length that the nuisances leave, the largest, in [0, 1] */
  /* kept < 1e-3, or length, of one prior width where there is one, below 1e-6: the observations
   * cannot see it. Its p are 1 */
  bool absorbed;
};

/* Rao's score test (Rao 1948, Proc. Camb. Phil. Soc. 44:50) for Gaussian observations of unit
 * sigma: residual [nobservation] whitened; out [ndirection]. UM_ERR_INPUT: nuisances without prior
 * as many as the observations or more. UM_ERR_MEMORY. Does not depend on the number of threads. */
enum um_status um_inference_score_test(struct um_context *context, size_t nobservation,
                                       const double *residual,
                                       const struct um_inference_nuisance *nuisance,
                                       size_t ndirection,
                                       const struct um_inference_direction *direction,
                                       struct um_inference_score *out);

/* Share of `draws` of white noise (keyed by seed) in which the least p of any direction is that
 * small or smaller: the p of a search among all of them, however alike they are. In [1 / (draws +
 * 1), 1]. UM_ERR_MEMORY. */
enum um_status um_inference_search_p(struct um_context *context, size_t nobservation,
                                     const struct um_inference_nuisance *nuisance,
                                     size_t ndirection,
                                     const struct um_inference_direction *direction, double least_p,
                                     size_t draws, uint64_t seed, double *out);

/* Expected chi-square by which the change `signal` [nobservation] (whitened) stands out against the
 * best that each direction (with the nuisances, priors of both in force, bounds not) can do in its
 * place: out [ndirection], in [0, |signal after nuisances|^2]. An alternative below
 * UM_INFERENCE_SEPARABLE cannot be told from the truth: it would win with probability
 * Phi(-sqrt(D)/2). */
enum um_status
um_inference_chi2_difference(struct um_context *context, size_t nobservation, const double *signal,
                             const struct um_inference_nuisance *nuisance, size_t ndirection,
                             const struct um_inference_direction *direction, double *out);

/* Is the residual itself white noise of unit variance? p of chi-square (upper tail) with dof, and
 * p of the autocorrelation of neighbours per channel, about zero (Ljung & Box 1978, Biometrika
 * 65:297, ten lags or a fifth of the observations), Fisher-combined over the channels of five
 * observations or more; 1 without such a channel. channel: [nobservation]. Observations of a
 * channel in order of time. UM_ERR_MEMORY. */
struct um_inference_whiteness {
  double chi2, dof, p_chi2;
  double p_white;
  double worst, p_worst; /* reduced chi-square of the worst channel, and its p among all channels */
};
enum um_status um_inference_whiteness_test(struct um_context *context, size_t nobservation,
                                           const double *residual, const size_t *channel,
                                           size_t nchannel, double fitted,
                                           struct um_inference_whiteness *out);

#endif
