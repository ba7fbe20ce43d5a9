/* Probabilities must be what they say: p-values of white noise are uniform, false alarms are as
 * rare as stated, and an error of one sigma is one. Fixed streams of noise; acceptance by the
 * Kolmogorov distribution or the binomial at a false-alarm rate of 1e-3 or less for each check. */
#include "base/core/constants.h"
#include "evidence/comparison/series.h"
#include "evidence/inversion/period.h"
#include "tests/evidence/metrics_test.h"

#define TRIALS 2000

static int compare_doubles(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Kolmogorov-Smirnov distance of p[n] from uniform, times sqrt n; beyond 1.95 once in 1000. */
static double uniform_distance(size_t n, double *p)
{
  double d = 0.0;
  qsort(p, n, sizeof *p, compare_doubles);
  for (size_t i = 0; i < n; i++) {
    d = fmax(d, fabs(p[i] - (double)i / (double)n));
    d = fmax(d, fabs(p[i] - (double)(i + 1) / (double)n));
  }
  return d * sqrt((double)n);
}

/* A complete model and honest sigmas: chi-square and whiteness p-values are uniform. */
static void check_noise(size_t rows)
{
  static double chi2_p[TRIALS], white_p[TRIALS];
  double y[64], m[64], s[64], reduced = 0.0;
  for (uint64_t k = 0; k < TRIALS; k++) {
    struct um_compare_metrics a;
    for (uint64_t i = 0; i < rows; i++) {
      m[i] = 1e-12 * (2.0 + sin(0.3 * (double)i));
      s[i] = hypot(0.02 * m[i], 3e-14);
      y[i] = m[i] + s[i] * gaussian(100 + k, i);
    }
    assert_ok(metrics_of(UM_QUANTITY_BAND_IRRADIANCE, rows, y, m, s, NULL, NULL, 0, 0.0, NULL, &a));
    chi2_p[k] = a.chi2_p;
    white_p[k] = a.white_p;
    reduced += a.chi2_reduced / TRIALS;
  }
  double chi2 = uniform_distance(TRIALS, chi2_p), white = uniform_distance(TRIALS, white_p);
  print_message("%zu rows: KS of chi2 %.3f, of whiteness %.3f, mean reduced chi2 %.4f\n", rows,
                chi2, white, reduced);
  assert_true(chi2 <= 1.95);
  assert_true(white <= 1.95);
  /* mean of dof-n reduced chi-squares: 1 +- sqrt(2 / n / trials), 3.3 of them */
  assert_close(reduced, 1.0, 3.3 * sqrt(2.0 / (double)rows / TRIALS));
}

static void test_noise(void **state)
{
  (void)state;
  check_noise(10);
  check_noise(60);
}

/* A slow drift with half the variance of the noise is seen in most series of 60 rows. */
static void test_power_of_whiteness(void **state)
{
  (void)state;
  int seen = 0;
  for (uint64_t k = 0; k < 200; k++) {
    double y[60], m[60] = {0}, s[60];
    struct um_compare_metrics a;
    for (uint64_t i = 0; i < 60; i++) {
      s[i] = 1.0;
      y[i] = sin(0.1 * (double)i) + gaussian(9000 + k, i);
    }
    assert_ok(metrics_of(UM_QUANTITY_COUNT_RATE, 60, y, m, s, NULL, NULL, 0, 0.0, NULL, &a));
    seen += a.white_p < 0.05 && a.durbin_watson < 2.0;
  }
  /* lag-1 correlation 1/3 of the variance, 1/sqrt(60) = 0.13 its error: 2.6 errors on average, so
   * most, and far more than the 2.5 % of noise */
  print_message("slow drift seen in %d of 200\n", seen);
  assert_true(seen >= 100);
}

/* A sine of amplitude 1.6 sigma in 80 rows explains 102 +- 20 of chi-square, so that 3.3 errors
 * below it still stand out. It is found, and its period errs by what is stated: the normalised
 * errors have variance 1 within 3.3 sqrt(2 / trials). */
static void test_period_error(void **state)
{
  (void)state;
  enum { N = 400 };
  double t[80], y[80], sum = 0.0, squares = 0.0, worst = 0.0;
  for (uint64_t k = 0; k < N; k++) {
    struct um_compare_series s = {.count = 80, .t = t, .value = y};
    struct um_compare_period *p;
    for (uint64_t i = 0; i < 80; i++) {
      t[i] = 5e8 + (double)i + 0.8 * um_core_hash_uniform(um_core_hash(40000 + k, i));
      y[i] = 1.6 * cos(2.0 * UM_PI * (t[i] - 5e8) / 6.4 + 0.7 * (double)k) + gaussian(50000 + k, i);
    }
    assert_ok(um_compare_period_search(context, &s, NULL, &p));
    worst = fmax(worst, p->false_alarm);
    double e = (p->period - 6.4) / p->period_sigma;
    sum += e;
    squares += e * e;
    um_compare_period_destroy(context, &p);
  }
  double mean = sum / N, variance = squares / N - mean * mean;
  print_message("errors of the period over their sigma: mean %.3f, variance %.3f\n", mean,
                variance);
  print_message("largest false-alarm probability of a true sine: %.2g\n", worst);
  assert_true(worst < 1e-2);
  assert_close(mean, 0.0, 3.3 / sqrt(N));
  assert_close(variance, 1.0, 3.3 * sqrt(2.0 / N));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_noise),
                                     cmocka_unit_test(test_power_of_whiteness),
                                     cmocka_unit_test(test_period_error)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
