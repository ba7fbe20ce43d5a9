/* Quantiles, exceedance, correlation and weights of many points. */
#include "base/uncertainty/statistics.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

#include "base/core/order.h"

struct weighed {
  double value, weight;
};

static int by_value(const void *a, const void *b)
{
  return um_core_order_double(&((const struct weighed *)a)->value,
                              &((const struct weighed *)b)->value);
}

/* Of m points in order: place of point i is (sum of weights before it + half its own) / sum. */
static double weighed_quantile(const struct weighed *w, size_t m, double sum, double p)
{
  double before = 0.0, last = -1.0;
  for (size_t i = 0; i < m; i++) {
    double place = (before + 0.5 * w[i].weight) / sum;
    before += w[i].weight;
    if (w[i].weight == 0.0) continue;
    if (place >= p) {
      if (last < 0.0) return w[i].value;
      size_t j = i; /* the one before that weighs something */
      while (j > 0 && w[--j].weight == 0.0) {
      }
      return w[j].value + (w[i].value - w[j].value) * (p - last) / (place - last);
    }
    last = place;
  }
  while (m > 1 && w[m - 1].weight == 0.0) m--;
  return w[m - 1].value;
}

static enum um_status check(struct um_context *context, size_t n, const double *weight, size_t np,
                            const double *p)
{
  for (size_t i = 0; i < np; i++)
    if (!(p[i] >= 0.0 && p[i] <= 1.0))
      return um_core_fail(context, UM_ERR_INPUT, "a quantile at %g, at least 0 and at most 1",
                          p[i]);
  for (size_t i = 0; i < n && weight != NULL; i++)
    if (!(weight[i] >= 0.0 && isfinite(weight[i])))
      return um_core_fail(context, UM_ERR_INPUT, "point %zu weighs %g", i, weight[i]);
  return UM_OK;
}

/* Points of value k that count, in order; plain [n] their values alone. */
static size_t gather(size_t n, size_t nvalue, const double *value, const double *weight, size_t k,
                     struct weighed *w, double *plain, double *sum)
{
  size_t m = 0;
  *sum = 0.0;
  for (size_t i = 0; i < n; i++) {
    double v = value[i * nvalue + k], by = weight != NULL ? weight[i] : 1.0;
    if (isnan(v)) continue;
    w[m++] = (struct weighed){.value = v, .weight = by};
    *sum += by;
  }
  qsort(w, m, sizeof *w, by_value);
  for (size_t i = 0; i < m; i++) plain[i] = w[i].value;
  return *sum > 0.0 ? m : 0;
}

enum um_status um_uncertainty_quantiles(struct um_context *context, size_t n, size_t nvalue,
                                        const double *value, const double *weight, size_t np,
                                        const double *p, double *out)
{
  enum um_status status;
  struct weighed *w = NULL;
  double *plain = NULL;
  UM_TRY(check(context, n, weight, np, p));
  UM_CHECK(um_core_allocate(context, n, sizeof *w, &w));
  UM_CHECK(um_core_allocate(context, n, sizeof *plain, &plain));
  for (size_t k = 0; k < nvalue; k++) {
    double sum;
    size_t m = gather(n, nvalue, value, weight, k, w, plain, &sum);
    if (k % 256 == 0) UM_CHECK(um_core_stop_check(context, "sorting the values of points"));
    for (size_t i = 0; i < np; i++)
      out[i * nvalue + k] = m == 0 ? NAN
                            : weight == NULL
                                ? gsl_stats_quantile_from_sorted_data(plain, 1, m, p[i])
                                : weighed_quantile(w, m, sum, p[i]);
  }
done:
  UM_FREE(context, w, plain);
  return status;
}

void um_uncertainty_mean(size_t n, size_t nvalue, const double *value, const double *weight,
                         double *mean, double *deviation)
{
  for (size_t k = 0; k < nvalue; k++) {
    double sum = 0.0, all = 0.0, squares = 0.0, count = 0.0;
    for (size_t i = 0; i < n; i++) {
      double v = value[i * nvalue + k], w = weight != NULL ? weight[i] : 1.0;
      if (isnan(v)) continue;
      all += w;
      sum += w * v;
      count += 1.0;
    }
    double m = all > 0.0 ? sum / all : NAN;
    for (size_t i = 0; i < n; i++) {
      double v = value[i * nvalue + k], w = weight != NULL ? weight[i] : 1.0;
      if (!isnan(v)) squares += w * (v - m) * (v - m);
    }
    if (mean != NULL) mean[k] = m;
    double degrees = weight != NULL ? all : count - 1.0;
    if (deviation != NULL) deviation[k] = degrees > 0.0 ? sqrt(squares / degrees) : NAN;
  }
}

void um_uncertainty_probability_above(size_t n, size_t nvalue, const double *value,
                                      const double *weight, const double *limit, double *out,
                                      double *error)
{
  for (size_t k = 0; k < nvalue; k++) {
    double above = 0.0, all = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++) {
      double v = value[i * nvalue + k], w = weight != NULL ? weight[i] : 1.0;
      if (isnan(v)) continue;
      all += w;
      squares += w * w;
      if (v > limit[k]) above += w;
    }
    out[k] = all > 0.0 ? above / all : NAN;
    if (error != NULL)
      error[k] = all > 0.0 ? sqrt(out[k] * fmax(1.0 - out[k], 0.0) * squares) / all : NAN;
  }
}

static bool varies(const double *x, size_t m)
{
  for (size_t i = 1; i < m; i++)
    if (x[i] != x[0]) return true;
  return false;
}

enum um_status um_uncertainty_rank_correlation(struct um_context *context, size_t n, size_t d,
                                               const double *parameter, size_t nvalue,
                                               const double *value, double *out)
{
  enum um_status status;
  double *x = NULL, *y = NULL, *work = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *x, &x));
  UM_CHECK(um_core_allocate(context, n, sizeof *y, &y));
  UM_CHECK(um_core_allocate(context, n, 2 * sizeof *work, &work));
  for (size_t k = 0; k < nvalue; k++) {
    if (k % 64 == 0) UM_CHECK(um_core_stop_check(context, "correlating points"));
    for (size_t i = 0; i < d; i++) {
      size_t m = 0;
      for (size_t j = 0; j < n; j++) {
        if (isnan(value[j * nvalue + k])) continue;
        x[m] = parameter[j * d + i];
        y[m++] = value[j * nvalue + k];
      }
      bool both = m > 1 && varies(x, m) && varies(y, m);
      out[i * nvalue + k] = both ? gsl_stats_spearman(x, 1, y, 1, m, work) : NAN;
    }
  }
done:
  UM_FREE(context, x, y, work);
  return status;
}

enum um_status um_uncertainty_weights(struct um_context *context, size_t n,
                                      const double *log_likelihood, double *out, double *effective)
{
  double best = -INFINITY, sum = 0.0, squares = 0.0;
  for (size_t i = 0; i < n; i++) {
    if (log_likelihood[i] == INFINITY)
      return um_core_fail(context, UM_ERR_INPUT, "point %zu has an infinite likelihood", i);
    best = fmax(best, log_likelihood[i]); /* the number where one is NaN */
  }
  if (best == -INFINITY)
    return um_core_fail(context, UM_ERR_INPUT, "none of %zu points has a likelihood", n);
  for (size_t i = 0; i < n; i++) {
    out[i] = isnan(log_likelihood[i]) ? 0.0 : exp(log_likelihood[i] - best);
    sum += out[i];
  }
  for (size_t i = 0; i < n; i++) {
    out[i] /= sum;
    squares += out[i] * out[i];
  }
  *effective = 1.0 / squares;
  return UM_OK;
}
