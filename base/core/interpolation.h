/* Interpolation and integration of tabulated functions. */
#ifndef UMBRA_CORE_INTERPOLATION_H
#define UMBRA_CORE_INTERPOLATION_H

#include <stddef.h>

/* Index i with x[i] <= v < x[i+1], clamped to [0, n-2]; x ascending, n >= 2. */
size_t um_core_interval_find(const double *x, size_t n, double v);
/* Piecewise linear y(v); constant outside the table. n >= 1. */
double um_core_interpolate(const double *x, const double *y, size_t n, double v);
/* The same in log y, for y > 0 (optical constants k); falls back to linear where y <= 0. */
double um_core_interpolate_log(const double *x, const double *y, size_t n, double v);
/* Exact integral of the piecewise linear function from a to b (a <= b); zero outside the table. */
double um_core_integrate_linear(const double *x, const double *y, size_t n, double a, double b);

#endif
