/* Draws from a density of a few parameters that is dear to compute and known up to a factor, by
 * adaptive importance sampling about where it is largest: every draw is computed once, none of them
 * waits for another of its round, and what they are worth is stated. */
#ifndef UMBRA_UNCERTAINTY_POSTERIOR_H
#define UMBRA_UNCERTAINTY_POSTERIOR_H

#include <stdint.h>

#include "base/core/context.h"

/* Draws that are handed out at once, at most, whatever computes them. */
#define UM_UNCERTAINTY_AT_ONCE 32
/* Equal draws that quantiles want at least: the median is then known within an eighth of a standard
 * deviation, sqrt(pi / 2 n). */
#define UM_UNCERTAINTY_EFFECTIVE_LEAST 100.0
/* Shape of the tail of the weights from which on they cannot be trusted (Vehtari et al. 2024, J.
 * Mach. Learn. Res. 25:72). */
#define UM_UNCERTAINTY_TAIL_MOST 0.7

struct um_uncertainty_posterior_problem {
  size_t nparameter, ndraw;   /* ndraw: of those that are computed, 1 at least */
  const double *centre;       /* [nparameter] about where the density is largest */
  const double *precision;    /* [nparameter][nparameter] of it there, inverse of the covariance */
  const double *least, *most; /* [nparameter] the density is 0 outside; may be infinite */
  /* Logarithm of the density, up to a constant, of n <= UM_UNCERTAINTY_AT_ONCE draws x
   * [n][nparameter] within the bounds, in order; -INFINITY or NaN: 0. Its errors are returned. */
  enum um_status (*density)(struct um_context *context, void *user, size_t n, const double *x,
                            double *log_density);
  void *user;
  uint64_t seed;
};

struct um_uncertainty_posterior {
  size_t n, nparameter;
  double *x;        /* [n][nparameter] in the order in which they were handed out */
  double *weight;   /* [n] sum 1 */
  double effective; /* equal draws that they are worth */
  double tail;      /* shape of the largest weights (um_uncertainty_tail); NaN: too few of them */
};

/* Each draw is a step of the caller's progress. The same draws for any number of processes.
 * UM_ERR_NUMERIC: the precision is not positive, the density is 0 at all draws, or nearly all of
 * the proposal is outside the bounds. UM_ERR_MEMORY. The caller destroys. Tests:
 * tests/base/uncertainty/posterior.c. */
enum um_status
um_uncertainty_posterior_create(struct um_context *context,
                                const struct um_uncertainty_posterior_problem *problem,
                                struct um_uncertainty_posterior **out);
/* Accepts NULL, sets NULL. */
void um_uncertainty_posterior_destroy(struct um_context *context,
                                      struct um_uncertainty_posterior **posterior);

/* Whether quantiles of the draws can be stated. */
bool um_uncertainty_posterior_is_sound(const struct um_uncertainty_posterior *posterior);
/* Weighted mean [d] and covariance [d][d] of draws x [n][d] whose weights [n] sum to 1. */
void um_uncertainty_covariance(size_t n, size_t d, const double *x, const double *weight,
                               double *mean, double *covariance);
/* Shape k of the generalised Pareto distribution of the largest min(n / 5, 3 sqrt n) weights above
 * the next (Zhang & Stephens 2009, Technometrics 51:316, with the prior of Vehtari et al.): the
 * mean of the weights exists below 1, their variance below 1/2. NaN: fewer than five of them, or
 * all alike. UM_ERR_MEMORY. */
enum um_status um_uncertainty_tail(struct um_context *context, size_t n, const double *weight,
                                   double *out);

#endif
