/* Sobol' indices by sampling (indices.h says by which formulas).
 *
 * Sums are kept per batch of rows: of f and f^2 of A and B, of the squares of both differences for
 * each parameter. A batch that ends is folded into the sums over all and into the mean and scatter
 * of the batches' own indices. Values are taken relative to the first row's f(A), so that a small
 * variation of large values keeps its digits. */
#include <math.h>
#include <string.h>

#include "base/uncertainty/indices.h"

struct sums {
  size_t d, nvalue;
  double *origin;        /* [nvalue] */
  double *n, *f, *f2;    /* [2][nvalue] rows, sums of f and of f^2 over A and B; 0: batch, 1: all */
  double *first, *total; /* [2][d][nvalue] sums of squared differences */
  double *scatter;       /* [4][d][nvalue] of the batches' first and total: sum, sum of squares */
  double *batches;       /* [nvalue] that have indices */
};

static enum um_status begin(struct um_context *context, struct sums *s, size_t d, size_t nvalue)
{
  s->d = d;
  s->nvalue = nvalue;
  UM_TRY(um_core_allocate(context, nvalue, sizeof(double), &s->origin));
  UM_TRY(um_core_allocate(context, nvalue, 2 * sizeof(double), &s->n));
  UM_TRY(um_core_allocate(context, nvalue, 2 * sizeof(double), &s->f));
  UM_TRY(um_core_allocate(context, nvalue, 2 * sizeof(double), &s->f2));
  UM_TRY(um_core_allocate(context, nvalue, 2 * d * sizeof(double), &s->first));
  UM_TRY(um_core_allocate(context, nvalue, 2 * d * sizeof(double), &s->total));
  UM_TRY(um_core_allocate(context, nvalue, 4 * d * sizeof(double), &s->scatter));
  UM_TRY(um_core_allocate(context, nvalue, sizeof(double), &s->batches));
  for (size_t k = 0; k < nvalue; k++) s->origin[k] = NAN;
  return UM_OK;
}

static void release(struct um_context *context, struct sums *s)
{
  UM_FREE(context, s->origin, s->n, s->f, s->f2, s->first, s->total, s->scatter, s->batches);
}

/* Value k of one row: A, B and the d points A_B^i, each `nvalue` behind the one before. */
static void add(struct sums *s, size_t k, const double *row)
{
  double a = row[k], b = row[s->nvalue + k], sum = a + b;
  for (size_t i = 0; i < s->d; i++) sum += row[(2 + i) * s->nvalue + k];
  if (!isfinite(sum)) return;
  if (isnan(s->origin[k])) s->origin[k] = a;
  a -= s->origin[k];
  b -= s->origin[k];
  s->n[k] += 1.0;
  s->f[k] += a + b;
  s->f2[k] += a * a + b * b;
  for (size_t i = 0; i < s->d; i++) {
    double ab = row[(2 + i) * s->nvalue + k] - s->origin[k];
    s->first[i * s->nvalue + k] += (b - ab) * (b - ab);
    s->total[i * s->nvalue + k] += (a - ab) * (a - ab);
  }
}

/* Variance of the values summed so far (which: 0 of the batch, 1 of all); 0 where it is rounding.
 */
static double variance_of(const struct sums *s, size_t which, size_t k)
{
  double n = 2.0 * s->n[which * s->nvalue + k], f = s->f[which * s->nvalue + k],
         f2 = s->f2[which * s->nvalue + k], scale = s->origin[k] * 1e-14;
  double v = n > 2.0 ? (f2 - f * f / n) / (n - 1.0) : 0.0;
  return v > scale * scale ? v : 0.0;
}

static double first_of(const struct sums *s, size_t which, size_t i, size_t k, double v)
{
  size_t at = (which * s->d + i) * s->nvalue + k;
  return 1.0 - s->first[at] / (2.0 * s->n[which * s->nvalue + k] * v);
}
static double total_of(const struct sums *s, size_t which, size_t i, size_t k, double v)
{
  size_t at = (which * s->d + i) * s->nvalue + k;
  return s->total[at] / (2.0 * s->n[which * s->nvalue + k] * v);
}

static void end_batch(struct sums *s, size_t k)
{
  size_t m = s->nvalue, all = s->d * m;
  double v = variance_of(s, 0, k);
  if (v > 0.0) {
    s->batches[k] += 1.0;
    for (size_t i = 0; i < s->d; i++) {
      double first = first_of(s, 0, i, k, v), total = total_of(s, 0, i, k, v);
      s->scatter[i * m + k] += first;
      s->scatter[all + i * m + k] += first * first;
      s->scatter[2 * all + i * m + k] += total;
      s->scatter[3 * all + i * m + k] += total * total;
    }
  }
  s->n[m + k] += s->n[k];
  s->f[m + k] += s->f[k];
  s->f2[m + k] += s->f2[k];
  s->n[k] = s->f[k] = s->f2[k] = 0.0;
  for (size_t i = 0; i < s->d; i++) {
    s->first[all + i * m + k] += s->first[i * m + k];
    s->total[all + i * m + k] += s->total[i * m + k];
    s->first[i * m + k] = s->total[i * m + k] = 0.0;
  }
}

/* A batch ends before row ceil(b n / batches). */
static void add_rows(const struct um_context *context, struct sums *s, size_t n,
                     const double *value)
{
  long nvalue = (long)s->nvalue;
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (long k = 0; k < nvalue; k++)
    for (size_t row = 0; row < n; row++) {
      add(s, (size_t)k, value + row * (s->d + 2) * s->nvalue);
      if ((row + 1) * UM_UNCERTAINTY_BATCHES / n != row * UM_UNCERTAINTY_BATCHES / n)
        end_batch(s, (size_t)k);
    }
}

/* Standard error of the mean of the batches. */
static double error_of(double batches, double sum, double squares)
{
  double v = (squares - sum * sum / batches) / (batches - 1.0);
  return sqrt(fmax(v, 0.0) / batches);
}

static void finish(const struct sums *s, struct um_uncertainty_sobol *out)
{
  size_t m = s->nvalue, all = s->d * m;
  for (size_t k = 0; k < m; k++) {
    double n = s->n[m + k], v = variance_of(s, 1, k);
    bool enough = n >= 2.0 * UM_UNCERTAINTY_BATCHES, some = enough && v > 0.0;
    bool scatter = some && s->batches[k] > 1.0;
    if (out->mean != NULL) out->mean[k] = enough ? s->origin[k] + s->f[m + k] / (2.0 * n) : NAN;
    if (out->variance != NULL) out->variance[k] = enough ? v : NAN;
    for (size_t i = 0; i < s->d; i++) {
      const double *of = s->scatter + i * m + k;
      size_t at = i * m + k;
      if (out->first != NULL) out->first[at] = some ? first_of(s, 1, i, k, v) : NAN;
      if (out->total != NULL) out->total[at] = some ? total_of(s, 1, i, k, v) : NAN;
      if (out->first_error != NULL)
        out->first_error[at] = scatter ? error_of(s->batches[k], of[0], of[all]) : NAN;
      if (out->total_error != NULL)
        out->total_error[at] = scatter ? error_of(s->batches[k], of[2 * all], of[3 * all]) : NAN;
    }
  }
}

static enum um_status check(struct um_context *context, size_t d, size_t n)
{
  if (d == 0) return um_core_fail(context, UM_ERR_INPUT, "Sobol indices of no parameters");
  if (n >= 2 * UM_UNCERTAINTY_BATCHES) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "Sobol indices of %zu rows, at least %d", n,
                      2 * UM_UNCERTAINTY_BATCHES);
}

enum um_status um_uncertainty_sobol_indices(struct um_context *context, size_t d, size_t n,
                                            size_t nvalue, const double *value,
                                            struct um_uncertainty_sobol *out)
{
  enum um_status status;
  struct sums s = {0};
  UM_TRY(check(context, d, n));
  UM_CHECK(begin(context, &s, d, nvalue));
  add_rows(context, &s, n, value);
  finish(&s, out);
done:
  release(context, &s);
  return status;
}
