/* Interpolation and integration of tabulated functions. */
#include "base/core/interpolation.h"

#include <math.h>

size_t um_core_interval_find(const double *x, size_t n, double v)
{
  size_t low = 0, high = n - 1;
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    if (x[middle] <= v)
      low = middle;
    else
      high = middle;
  }
  return low;
}

double um_core_interpolate(const double *x, const double *y, size_t n, double v)
{
  if (n == 1 || v <= x[0]) return y[0];
  if (v >= x[n - 1]) return y[n - 1];
  size_t i = um_core_interval_find(x, n, v);
  double u = (v - x[i]) / (x[i + 1] - x[i]);
  return y[i] + u * (y[i + 1] - y[i]);
}

double um_core_interpolate_log(const double *x, const double *y, size_t n, double v)
{
  if (n == 1 || v <= x[0]) return y[0];
  if (v >= x[n - 1]) return y[n - 1];
  size_t i = um_core_interval_find(x, n, v);
  double u = (v - x[i]) / (x[i + 1] - x[i]);
  if (!(y[i] > 0.0 && y[i + 1] > 0.0)) return y[i] + u * (y[i + 1] - y[i]);
  return exp(log(y[i]) + u * (log(y[i + 1]) - log(y[i])));
}

double um_core_integrate_linear(const double *x, const double *y, size_t n, double a, double b)
{
  if (n < 2) return 0.0;
  double from = fmax(a, x[0]), to = fmin(b, x[n - 1]);
  if (!(from < to)) return 0.0;
  double sum = 0.0;
  for (size_t i = um_core_interval_find(x, n, from); i + 1 < n && x[i] < to; i++) {
    double left = fmax(from, x[i]), right = fmin(to, x[i + 1]);
    if (!(left < right)) continue;
    double slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    /* the trapezoid is exact for a linear piece */
    sum += (right - left) * (y[i] + slope * (0.5 * (left + right) - x[i]));
  }
  return sum;
}
