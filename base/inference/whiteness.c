/* Is a residual white noise of unit variance? Its chi-square; that of the channel that fits worst,
 * so that a few observations are not lost among many (of m channels, p = 1 - (1 - min p)^m: Sidak
 * 1967, J. Am. Stat. Assoc. 62:626); and per channel the autocorrelation of neighbours about zero
 * (Ljung & Box 1978, Biometrika 65:297),
 *
 *   rho_k = sum_t e_t e_(t-k) / sum_t e_t^2,   Q = n (n + 2) sum_(k <= h) rho_k^2 / (n - k) ~
 * chi2_h,
 *
 * h = 10 or a fifth of the observations. The channels' p-values by Fisher (1932, Statistical
 * Methods for Research Workers, section 21.1): -2 sum ln p ~ chi2 of twice their number. */
#include <float.h>
#include <math.h>

#include "base/inference/distributions.h"
#include "base/inference/policy.h"
#include "base/inference/score.h"

/* p of e[n]; false when there are too few observations or all are 0. */
static bool ljung_box(size_t n, const double *e, double *p)
{
  size_t lags = n / UM_INFERENCE_ROWS_OF_A_LAG < UM_INFERENCE_LAGS_MAX
                    ? n / UM_INFERENCE_ROWS_OF_A_LAG
                    : UM_INFERENCE_LAGS_MAX;
  double squares = 0.0, q = 0.0, m = (double)n;
  for (size_t t = 0; t < n; t++) squares += e[t] * e[t];
  if (lags == 0 || squares == 0.0) return false;
  for (size_t k = 1; k <= lags; k++) {
    double product = 0.0;
    for (size_t t = k; t < n; t++) product += e[t] * e[t - k];
    double rho = product / squares;
    q += rho * rho / (m - (double)k);
  }
  *p = um_inference_chi2_q(m * (m + 2.0) * q, (double)lags);
  return true;
}

/* The channel whose chi-square is least likely; each pays its share of the fitted parameters. */
static void worst_channel(size_t nobservation, const double *residual, const size_t *channel,
                          size_t nchannel, struct um_inference_whiteness *out)
{
  double least = 1.0, tested = 0.0;
  for (size_t c = 0; c < nchannel; c++) {
    double chi2 = 0.0, n = 0.0;
    for (size_t i = 0; i < nobservation; i++) {
      if (channel[i] != c) continue;
      chi2 += residual[i] * residual[i];
      n += 1.0;
    }
    if (n == 0.0) continue;
    double dof = n * out->dof / (double)nobservation, p = um_inference_chi2_q(chi2, dof);
    tested += 1.0;
    if (p > least) continue;
    least = p;
    out->worst = chi2 / dof;
  }
  out->p_worst = -expm1(tested * log1p(-least));
}

enum um_status um_inference_whiteness_test(struct um_context *context, size_t nobservation,
                                           const double *residual, const size_t *channel,
                                           size_t nchannel, double fitted,
                                           struct um_inference_whiteness *out)
{
  enum um_status status;
  double *e = NULL, sum = 0.0, tested = 0.0;
  *out = (struct um_inference_whiteness){.dof = (double)nobservation - fitted, .p_white = 1.0};
  UM_CHECK(um_core_allocate(context, nobservation, sizeof *e, &e));
  for (size_t i = 0; i < nobservation; i++) out->chi2 += residual[i] * residual[i];
  out->p_chi2 = um_inference_chi2_q(out->chi2, out->dof);
  worst_channel(nobservation, residual, channel, nchannel, out);
  for (size_t c = 0; c < nchannel; c++) {
    size_t n = 0;
    for (size_t i = 0; i < nobservation; i++)
      if (channel[i] == c) e[n++] = residual[i];
    double p;
    if (!ljung_box(n, e, &p)) continue;
    sum -= 2.0 * log(p < DBL_MIN ? DBL_MIN : p); /* what underflowed is as good as that */
    tested += 1.0;
  }
  if (tested > 0.0) out->p_white = um_inference_chi2_q(sum, 2.0 * tested);
done:
  um_core_free(context, e);
  return status;
}
