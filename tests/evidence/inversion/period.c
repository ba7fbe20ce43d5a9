/* Period search against exact sines and against least squares done another way. */
#include "evidence/comparison/series.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>

#include "base/core/constants.h"
#include "evidence/inversion/period.h"
#include "tests/evidence/compare_test.h"

#define ROWS 120

static double times[ROWS], values[ROWS], sigmas[ROWS];

/* Uneven times over 100 s about an instant of this century, where a double of t resolves 1.2e-7 s.
 */
static void make_times(void)
{
  for (uint64_t i = 0; i < ROWS; i++)
    times[i] = 5e8 + (100.0 / ROWS) * ((double)i + 0.9 * um_core_hash_uniform(um_core_hash(1, i)));
}

static void test_exact_sine(void **state)
{
  (void)state;
  const double period = 7.3, peak = 5e8 + 3.1;
  make_times();
  for (int i = 0; i < ROWS; i++)
    values[i] = 4e-12 + 2.5e-12 * cos(2.0 * UM_PI * (times[i] - peak) / period);
  struct um_compare_series s = {.count = ROWS, .t = times, .value = values};
  struct um_compare_period *p;
  assert_ok(um_compare_period_search(context, &s, NULL, &p));
  /* golden section stops where the power, 1 - O(x^2), no longer changes in a double: x = 1e-8 of
   * the peak's width 1/T, in period 1e-8 P^2 / T = 5e-9 s; the same phase times P / 2 pi in epoch,
   * drawn over T / 2 */
  assert_close(p->period, period, 5e-8);
  assert_close(p->epoch, peak, 5e-7);
  assert_close(p->amplitude, 2.5e-12, 2.5e-18);
  assert_close(p->offset, 4e-12, 4e-18);
  assert_close(p->best_power, 1.0, 1e-13);
  assert_true(p->false_alarm <= 1e-200);
  assert_true(p->period_sigma < 1e-6);
  /* the grid: 2/T to half the inverse of the median step, 10 steps in 1/T */
  double span = times[ROWS - 1] - times[0];
  assert_close(p->frequency[0], 2.0 / span, 1e-15);
  assert_close(p->frequency[1] - p->frequency[0], 0.1 / span, 1e-14);
  assert_close(p->frequency[p->count - 1], 0.5 / (100.0 / ROWS), 0.05);
  um_compare_period_destroy(context, &p);
  assert_null(p);
  um_compare_period_destroy(context, NULL);
}

/* chi-square of a model of `ncolumn` columns by generalised least squares in noise of covariance V:
 * everything is divided by the Cholesky factor of V and solved by Householder's QR (GSL), without
 * filter and without orthogonalisation. */
static double chi2_dense(const gsl_matrix *cholesky, size_t ncolumn, double column[][ROWS])
{
  gsl_matrix *x = gsl_matrix_alloc(ROWS, ncolumn);
  gsl_vector *y = gsl_vector_alloc(ROWS), *tau = gsl_vector_alloc(ncolumn);
  gsl_vector *c = gsl_vector_alloc(ncolumn), *r = gsl_vector_alloc(ROWS);
  double chi2 = 0.0;
  for (size_t i = 0; i < ROWS; i++) {
    gsl_vector_set(y, i, values[i]);
    for (size_t k = 0; k < ncolumn; k++) gsl_matrix_set(x, i, k, column[k][i]);
  }
  gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, cholesky, y);
  gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1.0, cholesky, x);
  gsl_linalg_QR_decomp(x, tau);
  gsl_linalg_QR_lssolve(x, tau, y, c, r);
  for (size_t i = 0; i < ROWS; i++) chi2 += gsl_vector_get(r, i) * gsl_vector_get(r, i);
  gsl_matrix_free(x);
  gsl_vector_free(y);
  gsl_vector_free(tau);
  gsl_vector_free(c);
  gsl_vector_free(r);
  return chi2;
}

/* The power by its definition: 120 observations have a trend of the seventh degree. */
static double power_by_least_squares(double f, double red, double red_time)
{
  static double column[10][ROWS];
  double weight = 0.0;
  gsl_matrix *v = gsl_matrix_alloc(ROWS, ROWS);
  for (size_t i = 0; i < ROWS; i++) weight += 1.0 / (sigmas[i] * sigmas[i]) / ROWS;
  for (size_t i = 0; i < ROWS; i++) {
    for (size_t k = 0; k < ROWS; k++) {
      double c = red > 0.0 ? red * exp(-fabs(times[i] - times[k]) / red_time) : 0.0;
      gsl_matrix_set(v, i, k, c + (i == k ? sigmas[i] * sigmas[i] * weight : 0.0));
    }
    for (int k = 0; k < 8; k++) column[k][i] = pow((times[i] - 5e8) / 50.0 - 1.0, k);
    column[8][i] = cos(2.0 * UM_PI * f * (times[i] - 5e8));
    column[9][i] = sin(2.0 * UM_PI * f * (times[i] - 5e8));
  }
  gsl_linalg_cholesky_decomp1(v);
  double power = 1.0 - chi2_dense(v, 10, column) / chi2_dense(v, 8, column);
  gsl_matrix_free(v);
  return power;
}

static void make_values(bool coloured)
{
  double walk = 0.0;
  for (uint64_t i = 0; i < ROWS; i++) {
    walk = 0.8 * walk + (coloured ? 1.5 * gaussian(4, i) : 0.0);
    sigmas[i] = 0.5 + um_core_hash_uniform(um_core_hash(2, i));
    values[i] =
        10.0 + 3.0 * sin(2.0 * UM_PI * (times[i] - 5e8) / 13.0) + walk + sigmas[i] * gaussian(3, i);
  }
}

/* White and red noise under a trend, at every frequency. Tolerance 1e-11: sums of 120 products
 * round by 1e-14, and the condition of a sine beside a trend of the seventh degree may cost three
 * digits of that; errors are below 1e-13. */
static void test_least_squares(void **state)
{
  (void)state;
  make_times();
  for (int coloured = 0; coloured < 2; coloured++) {
    make_values(coloured == 1);
    struct um_compare_series s = {.count = ROWS, .t = times, .value = values, .sigma = sigmas};
    struct um_compare_period *p;
    assert_ok(um_compare_period_search(context, &s, NULL, &p));
    assert_int_equal(p->trend_terms, 8);
    if (coloured) assert_true(p->red > 0.0);
    for (size_t k = 0; k < p->count; k++)
      assert_close(p->power[k], power_by_least_squares(p->frequency[k], p->red, p->red_time),
                   1e-11);
    assert_close(p->best_power, power_by_least_squares(1.0 / p->period, p->red, p->red_time),
                 1e-11);
    for (size_t k = 0; k < p->count; k++) assert_true(p->power[k] <= p->best_power);
    assert_close(p->period, 13.0, 4.0 * p->period_sigma);
    assert_true(p->epoch >= times[0] && p->epoch < times[0] + p->period);
    um_compare_period_destroy(context, &p);
  }
}

/* The same bytes from one thread and from three. */
static void test_threads(void **state)
{
  (void)state;
  struct um_compare_series s = {.count = ROWS, .t = times, .value = values, .sigma = sigmas};
  struct um_compare_period *a, *b;
  int before = um_core_context_threads(context);
  um_core_context_set_threads(context, 1);
  assert_ok(um_compare_period_search(context, &s, NULL, &a));
  um_core_context_set_threads(context, 3);
  assert_ok(um_compare_period_search(context, &s, NULL, &b));
  um_core_context_set_threads(context, before);
  assert_int_equal(a->count, b->count);
  assert_memory_equal(a->power, b->power, a->count * sizeof *a->power);
  assert_true(a->period == b->period && a->false_alarm == b->false_alarm);
  um_compare_period_destroy(context, &a);
  um_compare_period_destroy(context, &b);
}

/* Even steps up to half the sampling rate, where the sine of each row is 0: an alternating series
 * is found there, and nothing is NaN. */
static void test_half_rate(void **state)
{
  (void)state;
  double t[16], y[16];
  for (int i = 0; i < 16; i++) {
    t[i] = i;
    y[i] = 3.0 + (i % 2 == 0 ? 1.0 : -1.0);
  }
  struct um_compare_series s = {.count = 16, .t = t, .value = y};
  struct um_compare_period *p;
  assert_ok(um_compare_period_search(context, &s, NULL, &p));
  assert_close(p->frequency[p->count - 1], 0.5, 1e-15);
  assert_close(p->power[p->count - 1], 1.0, 1e-12);
  assert_close(p->period, 2.0, 1e-14);
  for (size_t k = 0; k < p->count; k++) assert_true(p->power[k] >= 0.0 && p->power[k] <= 1.0);
  um_compare_period_destroy(context, &p);
}

static void test_refusals(void **state)
{
  (void)state;
  struct um_compare_period *p;
  double t[6] = {0, 1, 2, 3, 4, 5}, same[6] = {0}, y[6] = {1, 2, 1, 3, 1, 2};
  struct um_compare_series s = {.count = 4, .t = t, .value = y};
  struct um_compare_period_options o = {0};
  assert_refused(um_compare_period_search(context, &s, NULL, &p), UM_ERR_INPUT,
                 "period search: 4 observations; accepted: 5 or more");
  assert_null(p);
  s.count = 6;
  s.t = same;
  assert_refused(um_compare_period_search(context, &s, NULL, &p), UM_ERR_INPUT,
                 "period search: all 6 observations at one time; accepted: times that differ");
  s.t = t;
  s.value = same;
  assert_refused(um_compare_period_search(context, &s, NULL, &p), UM_ERR_INPUT,
                 "period search: all 6 values are equal; accepted: values that vary");
  s.value = y;
  o.frequency_min = 2.0;
  assert_refused(um_compare_period_search(context, &s, &o, &p), UM_ERR_INPUT,
                 "period search: frequencies from 2 to 0.5 Hz; accepted: above 0, from below to");
  o = (struct um_compare_period_options){.frequency_min = 0.2};
  assert_refused(
      um_compare_period_search(context, &s, &o, &p), UM_ERR_INPUT,
      "period search: frequencies from 0.2 Hz; accepted: 0.4 Hz or more, two turns in the "
      "5 s of the longest track");
  o = (struct um_compare_period_options){.frequency_max = 1e7};
  assert_refused(um_compare_period_search(context, &s, &o, &p), UM_ERR_INPUT,
                 "period search: 5e+08 frequencies over 5 s; accepted: at most 16777216 (narrow "
                 "the frequencies or take one track)");
  o = (struct um_compare_period_options){.oversampling = 0.5};
  assert_refused(um_compare_period_search(context, &s, &o, &p), UM_ERR_INPUT,
                 "period search: oversampling 0.5; accepted: 1 or more");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_exact_sine), cmocka_unit_test(test_least_squares),
      cmocka_unit_test(test_threads), cmocka_unit_test(test_half_rate),
      cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
