/* What residuals at points that had no say state of others that are drawn alike.
 *
 * Let r_1 .. r_n be a value's residuals at n points drawn as the others are, r that at another one,
 * and w(x) how errors are spread over the places x, up to a factor. Where r / w is normal about 0,
 * r / (w q) with q = sqrt(sum (r_i / w_i)^2 / n) follows Student's t with n degrees of freedom. So
 * among all places that will be asked the share of those with |r| > B is expected to be
 *
 *   mean over x of P(|t_n| > B / (w(x) q)) = miss,
 *
 * which is solved for B. The expectation is over the n points as well as the others; a mean of r
 * other than 0 makes it less. Of a curve the largest B over its values holds for each with that
 * share or less, so that of all values at all points no more than `miss` is expected beyond it,
 * however values hang together. A statement that is looked at several times, to go on where it says
 * too much, is one of several: look k has miss 2^-k, whose sum is below `miss` whichever is the
 * last one.
 *
 * Of a surrogate w is that of the terms that would come next: w^2 = sum (c_nu h_nu(x))^2 + its mean
 * / 10, c_nu the largest surplus of the terms one degree below. Such products are small nearly
 * everywhere and large in the corners of the ranges; with w = 1 the share beyond was three times as
 * large, and 8 functions of 40 in the test above `miss`. The tenth stands for terms of other
 * degrees. A statement is never less than the largest residual seen anywhere, those with it that
 * had a say. Tests: tests/base/uncertainty/stated.c. */
#ifndef UMBRA_UNCERTAINTY_STATED_H
#define UMBRA_UNCERTAINTY_STATED_H

#include <stddef.h>

/* t_(n, 1 - miss/2). n >= 1, miss in (0, 1): B / q where w is 1. */
double um_uncertainty_stated_factor(size_t n, double miss);
/* B / q over the places whose errors are spread like w [nplace], each above 0, n residuals. */
double um_uncertainty_stated_spread(const double *w, size_t nplace, size_t n, double miss);
/* sqrt(n / chi2_(n, miss)): with probability 1 - miss the root of the mean square of all normal
 * residuals is at most so many times that of n of them. */
double um_uncertainty_rms_factor(size_t n, double miss);

#endif
