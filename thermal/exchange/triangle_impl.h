/* Cholesky factors of a full matrix, kept as a triangle. Private to thermal/exchange/. */
#ifndef UMBRA_THERMAL_TRIANGLE_IMPL_H
#define UMBRA_THERMAL_TRIANGLE_IMPL_H

#include <stdbool.h>

#include "base/core/context.h"

#define UM_THERMAL_TOGETHER 8 /* columns side by side: a matrix is read once for them */

/* Row i of l[n (n + 1) / 2], of which i + 1 are kept. */
static inline double *um_thermal_triangle_row(double *l, size_t i) { return l + i * (i + 1) / 2; }

/* l: the lower triangle of a symmetric matrix in, L of L L^T out; *definite false: it has none. The
 * same bits for any number of threads. UM_ERR_CANCELLED, UM_ERR_MEMORY. */
enum um_status um_thermal_triangle_factorise(struct um_context *context, size_t n, double *l,
                                             bool *definite);
/* x[n][UM_THERMAL_TOGETHER] <- (L L^T)^-1 x. */
void um_thermal_triangle_solve(double *l, size_t n, double *x);

#endif
