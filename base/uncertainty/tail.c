/* What weighted draws are worth: their covariance, and the tail of their weights. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/uncertainty/posterior.h"

void um_uncertainty_covariance(size_t n, size_t d, const double *x, const double *weight,
                               double *mean, double *covariance)
{
  memset(mean, 0, d * sizeof *mean);
  memset(covariance, 0, d * d * sizeof *covariance);
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < d; k++) mean[k] += weight[i] * x[i * d + k];
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < d; k++)
      for (size_t l = 0; l < d; l++)
        covariance[k * d + l] += weight[i] * (x[i * d + k] - mean[k]) * (x[i * d + l] - mean[l]);
}

static int falling(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x < y) - (x > y);
}

/* Of z [m] rising, the first above 0. With theta = -k / sigma: a grid of theta, each weighed by its
 * profile likelihood. */
static double shape_of(const double *z, size_t m)
{
  enum { MOST = 200 };
  double theta[MOST], log_l[MOST], n = (double)m, top = -INFINITY, sum = 0.0, mean = 0.0, k = 0.0;
  size_t grid = 30 + (size_t)sqrt(n) < MOST ? 30 + (size_t)sqrt(n) : MOST;
  double quartile = z[(size_t)(n / 4.0 + 0.5) - 1];
  for (size_t j = 0; j < grid; j++) {
    double of = 0.0;
    theta[j] = 1.0 / z[m - 1] + (1.0 - sqrt((double)grid / ((double)j + 0.5))) / (3.0 * quartile);
    for (size_t i = 0; i < m; i++) of += log1p(-theta[j] * z[i]);
    of = -of / n;
    log_l[j] = n * (log(theta[j] / of) + of - 1.0);
    top = fmax(top, log_l[j]);
  }
  for (size_t j = 0; j < grid; j++) sum += exp(log_l[j] - top);
  for (size_t j = 0; j < grid; j++) mean += theta[j] * exp(log_l[j] - top) / sum;
  for (size_t i = 0; i < m; i++) k += log1p(-mean * z[i]) / n;
  return (k * n + 0.5 * 10.0) / (n + 10.0); /* as ten more whose shape is 1/2 */
}

enum um_status um_uncertainty_tail(struct um_context *context, size_t n, const double *weight,
                                   double *out)
{
  double *z = NULL;
  size_t m = (size_t)fmin(0.2 * (double)n, 3.0 * sqrt((double)n));
  *out = NAN;
  if (m < 5 || m >= n) return UM_OK;
  UM_TRY(um_core_allocate(context, n, sizeof *z, &z));
  memcpy(z, weight, n * sizeof *z);
  qsort(z, n, sizeof *z, falling);
  double above = z[m];
  for (size_t i = 0; i < (m + 1) / 2; i++) { /* rising, above the next */
    double low = z[m - 1 - i] - above, high = z[i] - above;
    z[i] = low;
    z[m - 1 - i] = high;
  }
  if (z[0] > 0.0) *out = shape_of(z, m);
  um_core_free(context, z);
  return UM_OK;
}
