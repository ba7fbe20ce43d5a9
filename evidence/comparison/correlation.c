/* Rank correlations by GSL. */
#include "evidence/comparison/correlation_impl.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"

#define FEWEST 5 /* pairs */

static bool constant(size_t n, const double *x)
{
  for (size_t i = 1; i < n; i++)
    if (x[i] != x[0]) return false;
  return true;
}

enum um_status um_compare_spearman(struct um_context *context, size_t n, const double *x,
                                   const double *y, double *r, double *p)
{
  double *work = NULL;
  *r = *p = NAN;
  if (n < FEWEST || constant(n, x) || constant(n, y)) return UM_OK;
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *work, &work));
  *r = gsl_stats_spearman(x, 1, y, 1, n, work);
  um_core_free(context, work);
  *r = fmin(1.0, fmax(-1.0, *r)); /* rounding */
  double dof = (double)n - 2.0, rest = 1.0 - *r * *r;
  *p = rest > 0.0 ? fmin(1.0, 2.0 * gsl_cdf_tdist_Q(fabs(*r) * sqrt(dof / rest), dof)) : 0.0;
  return UM_OK;
}

struct ranked {
  double value;
  size_t at;
};

static int by_value(const void *a, const void *b)
{
  const struct ranked *x = a, *y = b;
  if (x->value != y->value) return x->value < y->value ? -1 : 1;
  return x->at < y->at ? -1 : x->at > y->at;
}

/* Ranks, equal values sharing their mean. */
static void rank(size_t n, const double *y, struct ranked *order, double *out)
{
  for (size_t i = 0; i < n; i++) order[i] = (struct ranked){y[i], i};
  qsort(order, n, sizeof *order, by_value);
  for (size_t i = 0, end; i < n; i = end) {
    for (end = i; end < n && order[end].value == order[i].value; end++) {
    }
    for (size_t j = i; j < end; j++) out[order[j].at] = 0.5 * (double)(i + end - 1);
  }
}

enum um_status um_compare_circular(struct um_context *context, size_t n, const double *x,
                                   const double *y, double *r, double *p)
{
  struct ranked *order = NULL;
  double *work = NULL;
  enum um_status status = UM_OK;
  *r = *p = NAN;
  if (n < FEWEST || constant(n, x) || constant(n, y)) return UM_OK;
  UM_CHECK(um_core_allocate(context, n, sizeof *order, &order));
  UM_CHECK(um_core_allocate(context, 3 * n, sizeof *work, &work));
  double *ranks = work, *c = work + n, *s = work + 2 * n;
  rank(n, y, order, ranks);
  for (size_t i = 0; i < n; i++) {
    c[i] = cos(2.0 * UM_PI * x[i]);
    s[i] = sin(2.0 * UM_PI * x[i]);
  }
  double yc = gsl_stats_correlation(ranks, 1, c, 1, n);
  double ys = gsl_stats_correlation(ranks, 1, s, 1, n);
  double cs = gsl_stats_correlation(c, 1, s, 1, n);
  double r2 = (yc * yc + ys * ys - 2.0 * yc * ys * cs) / (1.0 - cs * cs);
  if (isfinite(r2)) {
    r2 = fmin(1.0, fmax(0.0, r2));
    *r = sqrt(r2);
    double dof = (double)n - 3.0;
    *p = r2 < 1.0 ? gsl_cdf_fdist_Q(dof * r2 / (1.0 - r2) / 2.0, 2.0, dof) : 0.0;
  }
done:
  UM_FREE(context, work, order);
  return status;
}
