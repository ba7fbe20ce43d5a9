/* Distributions and order statistics: the only place of compare/ that knows GSL. Nothing here
 * fails; arguments outside a domain give NaN. Private to the rooms of evidence/. */
#ifndef UMBRA_COMPARE_STATISTICS_GROUP_H
#define UMBRA_COMPARE_STATISTICS_GROUP_H

#include <stddef.h>

/* Median of x[n]; reorders x; NaN for n = 0. */
double um_compare_median(size_t n, double *x);
/* Pearson's correlation of x[n] and y[n] in [-1, 1]; NaN for n < 3 or when one is constant. */
double um_compare_pearson(size_t n, const double *x, const double *y);
/* Durbin-Watson statistic of e[n] about zero, d = sum (e_i - e_i-1)^2 / sum e_i^2 in [0, 4], and
 * its two-sided p-value for white noise; NaN for n < 3 or when all are zero. */
void um_compare_durbin_watson(size_t n, const double *e, double *d, double *p);

#endif
