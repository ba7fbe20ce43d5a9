/* Durbin-Watson statistic for white residuals without regressors. With A the second-difference
 * matrix (diagonal 1, 2, ..., 2, 1, beside it -1), d = e'Ae / e'e does not depend on the
 * denominator for Gaussian e, hence exactly (Durbin & Watson 1950, Biometrika 37, 409)
 *
 *   E(d) = tr A / n = 2 (n - 1) / n
 *   V(d) = 2 (n tr A^2 - (tr A)^2) / (n^2 (n + 2)) = 4 (n^2 - 2) / (n^2 (n + 2))
 *
 * and d / 4 is close to a beta variate of these moments (Durbin & Watson 1951, Biometrika 38, 159).
 */
#include "evidence/comparison/statistics_group.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

double um_compare_median(size_t n, double *x) { return n == 0 ? NAN : gsl_stats_median(x, 1, n); }

double um_compare_pearson(size_t n, const double *x, const double *y)
{
  if (n < 3) return NAN;
  double r = gsl_stats_correlation(x, 1, y, 1, n); /* 0 / 0 when one is constant */
  return isfinite(r) ? fmin(1.0, fmax(-1.0, r)) : (double)NAN;
}

void um_compare_durbin_watson(size_t n, const double *e, double *d, double *p)
{
  double differences = 0.0, squares = 0.0;
  *d = *p = NAN;
  for (size_t i = 0; i < n; i++) {
    squares += e[i] * e[i];
    if (i > 0) differences += (e[i] - e[i - 1]) * (e[i] - e[i - 1]);
  }
  if (n < 3 || !(squares > 0.0) || !isfinite(squares) || !isfinite(differences)) return;
  *d = differences / squares;
  double m = (double)n, mean = 2.0 * (m - 1.0) / m / 4.0;
  double variance = 4.0 * (m * m - 2.0) / (m * m * (m + 2.0)) / 16.0;
  double sum = mean * (1.0 - mean) / variance - 1.0; /* a + b of the beta variate */
  double x = *d / 4.0 < 1.0 ? *d / 4.0 : 1.0;
  double below = gsl_cdf_beta_P(x, mean * sum, (1.0 - mean) * sum);
  double above = gsl_cdf_beta_Q(x, mean * sum, (1.0 - mean) * sum);
  *p = fmin(1.0, 2.0 * fmin(below, above));
}
