/* For tests of linear statistics: noise that depends on its key alone, small normal equations. */
#ifndef UMBRA_TESTS_INFERENCE_ROWS_TEST_H
#define UMBRA_TESTS_INFERENCE_ROWS_TEST_H

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"

/* Standard normal (Box & Muller 1958). */
static inline double rows_normal(uint64_t key, uint64_t index)
{
  double u = um_core_hash_uniform(um_core_hash(key, 2 * index));
  double v = um_core_hash_uniform(um_core_hash(key, 2 * index + 1));
  return sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * UM_PI * v);
}

/* Least squares by the normal equations, column [n][nobservation], widths [n] of priors (mean
 * `mean`), by Gauss and Jordan; n <= 8. x [n]; variance [n] or NULL. Returns the minimum, priors
 * included. */
static inline double rows_normal_equations(size_t nobservation, size_t n, const double *column,
                                           const double *y, const double *width, const double *mean,
                                           double *x, double *variance)
{
  double a[8][17] = {{0}}, left = 0.0;
  for (size_t i = 0; i < n; i++) {
    double w = isinf(width[i]) ? 0.0 : 1.0 / (width[i] * width[i]);
    for (size_t j = 0; j < n; j++)
      for (size_t k = 0; k < nobservation; k++)
        a[i][j] += column[i * nobservation + k] * column[j * nobservation + k];
    a[i][i] += w;
    a[i][n + i] = 1.0;
    for (size_t k = 0; k < nobservation; k++) a[i][2 * n] += column[i * nobservation + k] * y[k];
    a[i][2 * n] += w * mean[i];
  }
  for (size_t i = 0; i < n; i++) {
    double pivot = a[i][i];
    for (size_t j = 0; j <= 2 * n; j++) a[i][j] /= pivot;
    for (size_t k = 0; k < n; k++) {
      double factor = a[k][i];
      for (size_t j = 0; k != i && j <= 2 * n; j++) a[k][j] -= factor * a[i][j];
    }
  }
  for (size_t i = 0; i < n; i++) {
    x[i] = a[i][2 * n];
    if (variance != NULL) variance[i] = a[i][n + i];
    if (!isinf(width[i])) left += (x[i] - mean[i]) * (x[i] - mean[i]) / (width[i] * width[i]);
  }
  for (size_t k = 0; k < nobservation; k++) {
    double r = y[k];
    for (size_t i = 0; i < n; i++) r -= column[i * nobservation + k] * x[i];
    left += r * r;
  }
  return left;
}

#endif
