/* Which directions a residual points in: score test with nuisance directions projected out, and
 * which directions cannot be told from each other. Linear statistics of whitened rows (value over
 * sigma); nothing here knows a model. */
#ifndef UMBRA_DIAGNOSIS_SCORE_H
#define UMBRA_DIAGNOSIS_SCORE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/context.h"

/* A group of columns that are tested as one. */
struct um_diagnosis_direction {
  size_t ncolumn;
  const double *column;       /* [ncolumn][nrow] whitened d(model)/d(parameter); borrowed */
  const double *minimum_step; /* [ncolumn] lowest and highest change of the parameter from null: */
  const double *maximum_step; /* 0 makes the test one-sided; +-INFINITY: none */
  const double *prior_sigma;  /* [ncolumn] INFINITY: none */
};

struct um_diagnosis_score {
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
  /* kept < 1e-3, or length, of one prior width where there is one, below 1e-6: the rows cannot see
   * it. Its p are 1 */
  bool absorbed;
};

/* Directions that may be present anyway: calibration factors, accepted effects. prior_sigma
 * INFINITY: free; 0: known, hence none. They may be collinear or dead. */
struct um_diagnosis_nuisance {
  size_t count;
  const double *column;      /* [count][nrow] whitened; borrowed */
  const double *prior_sigma; /* [count] */
};

/* Rao's score test (Rao 1948, Proc. Camb. Phil. Soc. 44:50) for Gaussian rows of unit sigma:
 * residual [nrow] whitened; out [ndirection]. UM_ERR_INPUT: nuisances without prior as many as the
 * rows or more. UM_ERR_MEMORY. Does not depend on the number of threads. */
enum um_status um_diagnosis_score_test(struct um_context *context, size_t nrow,
                                       const double *residual,
                                       const struct um_diagnosis_nuisance *nuisance,
                                       size_t ndirection,
                                       const struct um_diagnosis_direction *direction,
                                       struct um_diagnosis_score *out);

/* Expected chi-square by which the change `signal` [nrow] (whitened) stands out against the best
 * that each direction (with the nuisances, priors of both in force, bounds not) can do in its
 * place: out [ndirection], in [0, |signal after nuisances|^2]. A rival below UM_DIAGNOSIS_SEPARABLE
 * cannot be told from the truth: it would win with probability Phi(-sqrt(D)/2). */
#define UM_DIAGNOSIS_SEPARABLE 25.0
enum um_status um_diagnosis_separation(struct um_context *context, size_t nrow,
                                       const double *signal,
                                       const struct um_diagnosis_nuisance *nuisance,
                                       size_t ndirection,
                                       const struct um_diagnosis_direction *direction, double *out);

/* Is the residual itself white noise of unit variance? p of chi-square (upper tail) with dof, and
 * p of the autocorrelation of neighbours per channel, about zero (Ljung & Box 1978, Biometrika
 * 65:297, ten lags or a fifth of the rows), Fisher-combined over the channels of five rows or more;
 * 1 without such a channel. channel: [nrow]. Rows of a channel in order of time. UM_ERR_MEMORY. */
struct um_diagnosis_whiteness {
  double chi2, dof, p_chi2;
  double p_white;
  double worst, p_worst; /* reduced chi-square of the worst channel, and its p among all channels */
};
enum um_status um_diagnosis_whiteness_test(struct um_context *context, size_t nrow,
                                           const double *residual, const size_t *channel,
                                           size_t nchannel, double fitted,
                                           struct um_diagnosis_whiteness *out);

#endif
