/* A light curve made white: trend of every track and red noise between neighbours. Private to
 * evidence/inversion/. */
#ifndef UMBRA_COMPARE_PERIOD_NOISE_IMPL_H
#define UMBRA_COMPARE_PERIOD_NOISE_IMPL_H

#include "evidence/comparison/series.h"

#define UM_COMPARE_TREND_MAX 8 /* terms of a track's polynomial: to the seventh degree */

/* Observations of one track, in order of time; tracks do not know each other. */
struct um_compare_block {
  size_t first, count;
  size_t nterm; /* of its trend: 1 to UM_COMPARE_TREND_MAX */
};

/* A series, sorted by track and time. */
struct um_compare_curve {
  size_t n, nblock, nterm; /* nterm: of all blocks together */
  struct um_compare_block *block;
  double *t;                   /* [n] less origin [s] */
  double *y;                   /* [n] less offset */
  double *g;                   /* [n] variance of the white noise, mean weight 1 */
  size_t *row;                 /* [n] of the series */
  double origin, offset;       /* weighted mean time [s], weighted mean value */
  double first, span, longest; /* earliest time less origin; time spanned, by a track [s] */
  double variance;             /* weighted variance of t [s^2] */
  double yy;                   /* weighted mean square of y */
};
enum um_status um_compare_curve_create(struct um_context *context,
                                       const struct um_compare_series *series,
                                       struct um_compare_curve **out);
void um_compare_curve_destroy(struct um_context *context, struct um_compare_curve **curve);

/* Noise of a curve in units of its white noise: an Ornstein-Uhlenbeck process (AR(1) in continuous
 * time) of variance `red` and correlation time tau [s] beside it; red 0: white. */
struct um_compare_red {
  double red, tau;
};

/* A whitening filter for that noise (Kalman 1960 in innovations form) and the trend behind it. */
struct um_compare_white {
  const struct um_compare_curve *curve;
  double *phi, *gain, *scale; /* [n] */
  double *power;              /* [n][UM_COMPARE_TREND_MAX] of time in its block, -1 to 1 */
  double *trend;              /* [n][UM_COMPARE_TREND_MAX] whitened, orthonormal in a block */
  double *y;                  /* [n] whitened, without trend */
  double log_det;             /* ln det of the covariance, and of the trend's normal matrix */
  double chi2;                /* sum y^2 */
};
enum um_status um_compare_white_create(struct um_context *context,
                                       const struct um_compare_curve *curve,
                                       struct um_compare_white **out);
void um_compare_white_destroy(struct um_context *context, struct um_compare_white **white);
/* Set for a noise; does not fail. */
void um_compare_white_set(struct um_compare_white *white, const struct um_compare_red *noise);

/* Take the trends of all blocks out of a whitened column x, shape [n]. Does not fail. */
void um_compare_white_take_trend(const struct um_compare_white *white, double *x);

/* a cos(2 pi f t) + b sin(2 pi f t) beside the trend. */
struct um_compare_sine {
  double power; /* of chi-square explained [1] */
  double a, b;
};
struct um_compare_sine um_compare_white_sine(const struct um_compare_white *white,
                                             double frequency);

/* The noise that is most likely (restricted likelihood, the scale of the noise and the trend
 * integrated out) on a grid of red and tau, with a sine of this frequency in the model, or without
 * one for 0. minus2: -2 ln likelihood there. */
void um_compare_red_fit(struct um_compare_white *white, double frequency,
                        struct um_compare_red *noise, double *minus2);

#endif
