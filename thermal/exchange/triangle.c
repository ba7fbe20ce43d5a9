/* L L^T = M by blocks of columns, and solutions for as many right-hand sides. Everything is rows of
 * L times a panel [k][TOGETHER], four rows at a time: sums that do not wait for each other, each in
 * the order of k. */
#include "thermal/exchange/triangle_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/wide.h"

#define TOGETHER UM_THERMAL_TOGETHER
#define ROWS     4
#define WORTH    256 /* rows: fewer take less time than threads need to meet */

/* sum[ROWS][TOGETHER] = rows i, i + 1, .. of L to column n, times the panel. */
UM_WIDE_VECTORS static void four_rows(const double *a, const double *b, const double *c,
                                      const double *d, const double *panel, size_t n, double *out)
{
  double s0[TOGETHER] = {0.0}, s1[TOGETHER] = {0.0}, s2[TOGETHER] = {0.0}, s3[TOGETHER] = {0.0};
  for (size_t k = 0; k < n; k++) {
    const double *x = panel + k * TOGETHER;
    for (size_t q = 0; q < TOGETHER; q++) s0[q] += a[k] * x[q];
    for (size_t q = 0; q < TOGETHER; q++) s1[q] += b[k] * x[q];
    for (size_t q = 0; q < TOGETHER; q++) s2[q] += c[k] * x[q];
    for (size_t q = 0; q < TOGETHER; q++) s3[q] += d[k] * x[q];
  }
  memcpy(out, s0, sizeof s0);
  memcpy(out + TOGETHER, s1, sizeof s1);
  memcpy(out + 2 * TOGETHER, s2, sizeof s2);
  memcpy(out + 3 * TOGETHER, s3, sizeof s3);
}

/* The same of rows [i, i + count), count up to ROWS. */
static void rows_times(double *l, size_t i, size_t count, const double *panel, size_t n,
                       double *sum)
{
  const double *row[ROWS];
  for (size_t r = 0; r < ROWS; r++)
    row[r] = um_thermal_triangle_row(l, i + (r < count ? r : count - 1));
  four_rows(row[0], row[1], row[2], row[3], panel, n, sum);
}

/* Columns [first, first + width) of rows [i, i + count): what earlier columns have of them is
 * taken away; where `done`, the block's own are as well. */
static void columns_take(double *l, size_t first, size_t width, size_t i, size_t count,
                         const double *panel, bool done)
{
  double sum[ROWS * TOGETHER];
  rows_times(l, i, count, panel, first, sum);
  for (size_t r = 0; r < count; r++) {
    double *row = um_thermal_triangle_row(l, i + r);
    for (size_t c = 0; c < width && first + c <= i + r; c++) {
      row[first + c] -= sum[r * TOGETHER + c];
      if (!done) continue;
      const double *own = um_thermal_triangle_row(l, first + c);
      for (size_t d = first; d < first + c; d++) row[first + c] -= row[d] * own[d];
      row[first + c] /= own[first + c];
    }
  }
}

/* The triangle at the top of the block. */
static bool top_take(double *l, size_t first, size_t width)
{
  for (size_t i = first; i < first + width; i++) {
    double *row = um_thermal_triangle_row(l, i);
    for (size_t j = first; j <= i; j++) {
      const double *other = um_thermal_triangle_row(l, j);
      for (size_t k = first; k < j; k++) row[j] -= row[k] * other[k];
      if (j < i)
        row[j] /= other[j];
      else if (row[j] > 0.0)
        row[j] = sqrt(row[j]);
      else
        return false;
    }
  }
  return true;
}

enum um_status um_thermal_triangle_factorise(struct um_context *context, size_t n, double *l,
                                             bool *definite)
{
  enum um_status status = UM_OK;
  double *panel = NULL;
  *definite = true;
  UM_TRY(um_core_allocate(context, n * TOGETHER, sizeof *panel, &panel));
  for (size_t first = 0; first < n && *definite; first += TOGETHER) {
    size_t width = n - first < TOGETHER ? n - first : TOGETHER, below = first + width;
    for (size_t c = 0; c < width; c++)
      for (size_t k = 0; k < first; k++)
        panel[k * TOGETHER + c] = um_thermal_triangle_row(l, first + c)[k];
    for (size_t i = first; i < below; i += ROWS)
      columns_take(l, first, width, i, below - i < ROWS ? below - i : ROWS, panel, false);
    *definite = top_take(l, first, width);
    long group = *definite ? (long)((n - below + ROWS - 1) / ROWS) : 0;
#pragma omp parallel for schedule(static)                                                          \
    num_threads(um_core_context_threads(context)) if (n - below > WORTH)
    for (long g = 0; g < group; g++) {
      size_t i = below + (size_t)g * ROWS;
      columns_take(l, first, width, i, n - i < ROWS ? n - i : ROWS, panel, true);
    }
    UM_CHECK(um_core_stop_check(context, "reflections were added up"));
  }
done:
  um_core_free(context, panel);
  return status;
}

/* x[k] -= rows [i, i + ROWS) of L at k times y[ROWS][TOGETHER], k < n. */
UM_WIDE_VECTORS static void take_back(const double *a, const double *b, const double *c,
                                      const double *d, const double *y, size_t n, double *x)
{
  for (size_t k = 0; k < n; k++)
    for (size_t q = 0; q < TOGETHER; q++)
      x[k * TOGETHER + q] -= (a[k] * y[q] + b[k] * y[TOGETHER + q]) +
                             (c[k] * y[2 * TOGETHER + q] + d[k] * y[3 * TOGETHER + q]);
}

/* Rows [i, i + count) of x, what is above and, backwards, below them taken away. */
static void corner_solve(double *l, size_t i, size_t count, bool back, double *x)
{
  for (size_t at = 0; at < count; at++) {
    size_t r = i + (back ? count - 1 - at : at);
    for (size_t s = back ? r + 1 : i; s < (back ? i + count : r); s++) {
      double factor = back ? um_thermal_triangle_row(l, s)[r] : um_thermal_triangle_row(l, r)[s];
      for (size_t q = 0; q < TOGETHER; q++) x[r * TOGETHER + q] -= factor * x[s * TOGETHER + q];
    }
    double own = um_thermal_triangle_row(l, r)[r];
    for (size_t q = 0; q < TOGETHER; q++) x[r * TOGETHER + q] /= own;
  }
}

void um_thermal_triangle_solve(double *l, size_t n, double *x)
{
  double sum[ROWS * TOGETHER];
  size_t whole = n - n % ROWS;
  for (size_t i = 0; i < n; i += ROWS) {
    size_t count = n - i < ROWS ? n - i : ROWS;
    rows_times(l, i, count, x, i, sum);
    for (size_t k = 0; k < count * TOGETHER; k++) x[i * TOGETHER + k] -= sum[k];
    corner_solve(l, i, count, false, x);
  }
  for (size_t i = whole + ROWS; i > 0;) {
    i -= ROWS;
    size_t count = n - i < ROWS ? n - i : ROWS;
    if (count == 0) continue;
    corner_solve(l, i, count, true, x);
    const double *row[ROWS];
    double y[ROWS * TOGETHER] = {0.0}; /* rows that are not there take nothing away */
    memcpy(y, x + i * TOGETHER, count * TOGETHER * sizeof *y);
    for (size_t r = 0; r < ROWS; r++)
      row[r] = um_thermal_triangle_row(l, i + (r < count ? r : count - 1));
    take_back(row[0], row[1], row[2], row[3], y, i, x);
  }
}
