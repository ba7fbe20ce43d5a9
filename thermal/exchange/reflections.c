/* All orders of diffuse reflection between patches,
 *
 *   B = S (1 - r A^-1 S)^-1 = S + S R (1 - R S R)^-1 R S,   R = sqrt(r / A),
 *
 * by Cholesky factors: 1 - R S R is symmetric and positive definite where light finds a way out of
 * every room or into one of its walls. With L L^T = 1 - R S R and Y = L^-1 R S: B = S + Y^T Y. */
#include <math.h>

#include "thermal/exchange/exchange_group.h"

#define WHITEST (1.0 - 1e-9) /* largest reflectance: a white room has no balance */
#define COLUMNS 64           /* solved at a time */

/* L in place of the lower triangle of m; false: not positive definite. */
static bool cholesky(double *m, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    double *row = m + i * n;
    for (size_t j = 0; j <= i; j++) {
      const double *other = m + j * n;
      double sum = row[j];
      for (size_t k = 0; k < j; k++) sum -= row[k] * other[k];
      if (j < i)
        row[j] = sum / other[j];
      else if (sum > 0.0)
        row[j] = sqrt(sum);
      else
        return false;
    }
  }
  return true;
}

/* y <- L^-1 y for columns [from, to). */
static void forward(const double *l, double *y, size_t n, size_t from, size_t to)
{
  for (size_t i = 0; i < n; i++) {
    double *row = y + i * n;
    for (size_t k = 0; k < i; k++) {
      double factor = l[i * n + k];
      const double *other = y + k * n;
      for (size_t q = from; factor != 0.0 && q < to; q++) row[q] -= factor * other[q];
    }
    for (size_t q = from; q < to; q++) row[q] /= l[i * n + i];
  }
}

/* m = 1 - R S R, y = R S, b = S. */
static void fill(const struct um_geometry_view_factors *f, const double *root, double *m, double *y,
                 double *b)
{
  size_t n = f->npatch;
  for (size_t i = 0; i < n * n; i++) m[i] = y[i] = b[i] = 0.0;
  for (size_t p = 0; p < n; p++) {
    m[p * n + p] = 1.0;
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      size_t q = f->other[e];
      m[p * n + q] -= root[p] * f->area[e] * root[q];
      y[p * n + q] = root[p] * f->area[e];
      b[p * n + q] = f->area[e];
    }
  }
}

enum um_status um_thermal_reflections(struct um_context *context,
                                      const struct um_geometry_view_factors *factors,
                                      const double *area, const double *reflectance, double *b)
{
  enum um_status status;
  size_t n = factors->npatch;
  double *root = NULL, *m = NULL, *y = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *root, &root));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *m, &m));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *y, &y));
  for (size_t p = 0; p < n; p++) root[p] = sqrt(fmin(fmax(reflectance[p], 0.0), WHITEST) / area[p]);
  fill(factors, root, m, y, b);
  if (!cholesky(m, n)) {
    status = um_core_fail(context, UM_ERR_NUMERIC,
                          "light between surfaces finds no end: a room without a way out whose "
                          "walls absorb nothing; accepted: walls that absorb");
    goto done;
  }
  UM_CHECK(um_core_stop_check(context, "reflections were added up"));
  long blocks = (long)((n + COLUMNS - 1) / COLUMNS), rows = (long)n;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
  for (long k = 0; k < blocks; k++) {
    size_t from = (size_t)k * COLUMNS, to = from + COLUMNS;
    forward(m, y, n, from, to < n ? to : n);
  }
#pragma omp parallel for schedule(dynamic, 8) num_threads(um_core_context_threads(context))
  for (long p = 0; p < rows; p++) {
    double *row = b + (size_t)p * n;
    for (size_t k = 0; k < n; k++) {
      double factor = y[k * n + (size_t)p];
      const double *other = y + k * n;
      for (size_t q = 0; factor != 0.0 && q < n; q++) row[q] += factor * other[q];
    }
  }
done:
  UM_FREE(context, root, m, y);
  return status;
}
