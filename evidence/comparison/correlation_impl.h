/* How a residual goes with a coordinate. Private to evidence/comparison/. */
#ifndef UMBRA_COMPARE_CORRELATION_IMPL_H
#define UMBRA_COMPARE_CORRELATION_IMPL_H

#include "base/core/context.h"

/* Spearman's rank correlation of x[n] and y[n], ties by mean ranks, in [-1, 1], and its two-sided
 * p-value for independent pairs by Student's t with n - 2 degrees of freedom. NaN where n < 5 or
 * one of them is constant. UM_ERR_MEMORY. */
enum um_status um_compare_spearman(struct um_context *context, size_t n, const double *x,
                                   const double *y, double *r, double *p);
/* Circular-linear correlation of ranks, in [0, 1]: x[n] a phase in turns. With c, s the cosine and
 * sine of the phase (Mardia 1976, Biometrika 63, 403)
 *   R^2 = (r_yc^2 + r_ys^2 - 2 r_yc r_ys r_cs) / (1 - r_cs^2),
 * y by its ranks; (n - 3) R^2 / (1 - R^2) / 2 is compared with F of 2 and n - 3. */
enum um_status um_compare_circular(struct um_context *context, size_t n, const double *x,
                                   const double *y, double *r, double *p);

#endif
