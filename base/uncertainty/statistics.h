/* What many points say of each value: quantiles, exceedance, correlation; and points weighed by how
 * well they fit measurements. value [n][nvalue] throughout; a value that is NaN at a point is left
 * out there. weight [n] >= 0 or NULL, all alike. Tests: tests/base/uncertainty/statistics.c. */
#ifndef UMBRA_UNCERTAINTY_STATISTICS_H
#define UMBRA_UNCERTAINTY_STATISTICS_H

#include "base/core/context.h"

/* Quantiles at p [np] in [0, 1], out [np][nvalue]; NaN where no point has the value. Without
 * weights GSL's (linear between order statistics: the i-th of m is at (i - 1) / (m - 1)); with
 * weights linear between the middles of the points' shares, the ends held. UM_ERR_INPUT: p outside,
 * a weight below 0 or not finite. UM_ERR_MEMORY. */
enum um_status um_uncertainty_quantiles(struct um_context *context, size_t n, size_t nvalue,
                                        const double *value, const double *weight, size_t np,
                                        const double *p, double *out);

/* Mean and standard deviation (unbiased without weights), out [nvalue]; either may be NULL. */
void um_uncertainty_mean(size_t n, size_t nvalue, const double *value, const double *weight,
                         double *mean, double *deviation);

/* Probability that a value is above a limit [nvalue], and its standard error sqrt(p (1 - p) / m),
 * m the points, effective ones with weights; out [nvalue], error may be NULL. NaN: no point. */
void um_uncertainty_probability_above(size_t n, size_t nvalue, const double *value,
                                      const double *weight, const double *limit, double *out,
                                      double *error);

/* Spearman's rank correlation of every value with every parameter [n][d], out [d][nvalue], by GSL;
 * NaN where either does not vary. UM_ERR_MEMORY. */
enum um_status um_uncertainty_rank_correlation(struct um_context *context, size_t n, size_t d,
                                               const double *parameter, size_t nvalue,
                                               const double *value, double *out);

/* Weights of points drawn from the prior that make them the posterior: w = exp(l) / sum exp(l) of
 * their log-likelihoods l [n], NaN or -INFINITY weighing nothing; out [n], sum 1. effective: 1 /
 * sum w^2, how many equal points they are worth (Kong, Liu & Wong 1994, J. Am. Stat. Assoc.
 * 89:278). UM_ERR_INPUT: no point has a likelihood, one is +INFINITY. */
enum um_status um_uncertainty_weights(struct um_context *context, size_t n,
                                      const double *log_likelihood, double *out, double *effective);

#endif
