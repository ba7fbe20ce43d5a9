/* A smooth discrepancy by channel: r = d + e with e white of unit variance and d a Gaussian process
 * with covariance a^2 exp(-dt^2 / (2 l^2)) (Kennedy and O'Hagan 2001, J. R. Stat. Soc. B 63:425;
 * Rasmussen and Williams 2006, Gaussian Processes for Machine Learning, eqs. 2.25 and 2.30). Scale
 * and amplitude are those of greatest likelihood on a grid. */
#include <math.h>
#include <string.h>

#include "base/inference/distributions.h"
#include "tests/bench/worlds.h"

/* of the channel's span [1], and of the noise [1] */
static const double scales[] = {0.02, 0.05, 0.1, 0.2, 0.5};
static const double amplitudes[] = {0.3, 1.0, 3.0, 10.0, 30.0, 100.0};
#define NSCALE     (sizeof scales / sizeof scales[0])
#define NAMPLITUDE (sizeof amplitudes / sizeof amplitudes[0])
#define LEVEL      0.01
#define LEARNT     2.0 /* scale and amplitude */

/* l [n][n] <- lower Cholesky factor of the covariance of r. It is at least 1 in every direction. */
static void factor(size_t n, const double *t, double scale, double amplitude, double *l)
{
  for (size_t i = 0; i < n; i++)
    for (size_t j = 0; j <= i; j++) {
      double x = (t[i] - t[j]) / scale;
      double sum = amplitude * amplitude * exp(-0.5 * x * x) + (i == j ? 1.0 : 0.0);
      for (size_t k = 0; k < j; k++) sum -= l[i * n + k] * l[j * n + k];
      l[i * n + j] = i == j ? sqrt(fmax(sum, 1e-12)) : sum / l[j * n + j];
    }
}

/* x <- (L L')^-1 r; the logarithm of the likelihood, without its constant. */
static double solve(size_t n, const double *l, const double *r, double *x)
{
  double log_likelihood = 0.0;
  for (size_t i = 0; i < n; i++) {
    x[i] = r[i];
    for (size_t k = 0; k < i; k++) x[i] -= l[i * n + k] * x[k];
    x[i] /= l[i * n + i];
    log_likelihood -= 0.5 * x[i] * x[i] + log(l[i * n + i]);
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; k++) x[i] -= l[k * n + i] * x[k];
    x[i] /= l[i * n + i];
  }
  return log_likelihood;
}

/* One channel: mean [n] of the process, or zeros. l [n][n] and x [n] are room. */
static bool one_channel(size_t n, const double *t, const double *r, double *l, double *x,
                        double *mean)
{
  double none = 0.0, best = -INFINITY, first = INFINITY, last = -INFINITY;
  for (size_t i = 0; i < n; i++) {
    none -= 0.5 * r[i] * r[i];
    first = fmin(first, t[i]);
    last = fmax(last, t[i]);
  }
  for (size_t s = 0; s < NSCALE && last > first; s++)
    for (size_t a = 0; a < NAMPLITUDE; a++) {
      factor(n, t, scales[s] * (last - first), amplitudes[a], l);
      double log_likelihood = solve(n, l, r, x);
      if (!(log_likelihood > best)) continue;
      best = log_likelihood;
      for (size_t i = 0; i < n; i++) mean[i] = r[i] - x[i];
    }
  if (um_inference_chi2_q(2.0 * (best - none), LEARNT) < LEVEL) return true;
  memset(mean, 0, n * sizeof *mean);
  return false;
}

enum um_status worlds_discrepancy(struct um_context *context, size_t n, const double *t,
                                  const size_t *channel, size_t nchannel, const double *r,
                                  double *out, bool *found)
{
  enum um_status status;
  double *block = NULL;
  *found = false;
  UM_CHECK(um_core_allocate(context, n * n + 4 * n, sizeof *block, &block));
  double *tc = block + n * n, *rc = tc + n, *x = rc + n, *mean = x + n;
  for (size_t c = 0; c < nchannel; c++) {
    size_t m = 0;
    for (size_t i = 0; i < n; i++)
      if (channel[i] == c) {
        tc[m] = t[i];
        rc[m++] = r[i];
      }
    *found |= one_channel(m, tc, rc, block, x, mean);
    m = 0;
    for (size_t i = 0; i < n; i++)
      if (channel[i] == c) out[i] = mean[m++];
  }
done:
  um_core_free(context, block);
  return status;
}
