/* Quantiles, exceedance, correlation and weights against closed forms. */
#include "base/uncertainty/statistics.h"

#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

enum { N = 2001 };

/* Values 0, 1, .. 2000 in another order; a second value that is NaN at half the points, a third
 * nowhere. */
static void fill(double *value)
{
  for (size_t i = 0; i < N; i++) {
    double v = (double)(i * 1009 % N);
    value[3 * i] = v;
    value[3 * i + 1] = i % 2 == 0 ? NAN : v;
    value[3 * i + 2] = NAN;
  }
}

static void test_quantiles(void **state)
{
  (void)state;
  double value[3 * N], weight[N], out[3][3], p[3] = {0.0, 0.05, 0.5};
  fill(value);
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, NULL, 3, p, *out), UM_OK);
  assert_close(out[0][0], 0.0, 0.0);
  assert_close(out[1][0], 100.0, 1e-10);
  assert_close(out[2][0], 1000.0, 1e-10);
  assert_close(out[2][1], 1000.0, 60.0);
  assert_true(isnan(out[1][2]));
  /* equal weights say the same within half a share; weights that grow like the value: p = x^2 */
  for (size_t i = 0; i < N; i++) weight[i] = 0.25;
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, weight, 3, p, *out), UM_OK);
  assert_close(out[1][0], 100.0, 0.51);
  assert_close(out[2][0], 1000.0, 0.51);
  for (size_t i = 0; i < N; i++) weight[i] = value[3 * i];
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, weight, 3, p, *out), UM_OK);
  assert_close(out[2][0], 2000.0 * sqrt(0.5), 1.0);
  /* all the weight on two points */
  for (size_t i = 0; i < N; i++)
    weight[i] = value[3 * i] == 70.0 || value[3 * i] == 90.0 ? 1.0 : 0.0;
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, weight, 3, p, *out), UM_OK);
  assert_close(out[0][0], 70.0, 0.0);
  assert_close(out[2][0], 80.0, 1e-12);
  double beyond = 1.5;
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, NULL, 1, &beyond, *out),
                   UM_ERR_INPUT);
  um_core_message_clear(context);
  weight[3] = -1.0;
  assert_int_equal(um_uncertainty_quantiles(context, N, 3, value, weight, 3, p, *out),
                   UM_ERR_INPUT);
  um_core_message_clear(context);
}

static void test_mean_and_above(void **state)
{
  (void)state;
  double value[3 * N], mean[3], deviation[3], above[3], error[3], weight[N];
  const double limit[3] = {1499.5, 1499.5, 0.0};
  fill(value);
  um_uncertainty_mean(N, 3, value, NULL, mean, deviation);
  assert_close(mean[0], 1000.0, 1e-9);
  assert_close(deviation[0], sqrt((double)N * (N + 1.0) / 12.0), 1e-9);
  assert_true(isnan(mean[2]) && isnan(deviation[2]));
  um_uncertainty_probability_above(N, 3, value, NULL, limit, above, error);
  assert_close(above[0], 501.0 / N, 1e-12);
  assert_close(error[0], sqrt(501.0 / N * 1500.0 / N / N), 1e-12);
  assert_true(isnan(above[2]));
  for (size_t i = 0; i < N; i++) weight[i] = value[3 * i] > 1000.0 ? 2.0 : 0.0;
  um_uncertainty_probability_above(N, 3, value, weight, limit, above, error);
  assert_close(above[0], 0.501, 1e-12);
  assert_close(error[0], sqrt(0.501 * 0.499 / 1000.0), 1e-12);
}

/* Ranks do not see a monotonic law: 1 and -1; of x^2 on both sides of 0 none. */
static void test_correlation(void **state)
{
  (void)state;
  double parameter[2 * N], value[3 * N], out[2][3];
  for (size_t i = 0; i < N; i++) {
    double x = 2.0 * um_core_hash_uniform(um_core_hash(4, i)) - 1.0;
    parameter[2 * i] = x;
    parameter[2 * i + 1] = um_core_hash_uniform(um_core_hash(5, i));
    value[3 * i] = exp(5.0 * x);
    value[3 * i + 1] = -x * x * x;
    value[3 * i + 2] = i == 3 ? NAN : x * x;
  }
  assert_int_equal(um_uncertainty_rank_correlation(context, N, 2, parameter, 3, value, *out),
                   UM_OK);
  assert_close(out[0][0], 1.0, 1e-12);
  assert_close(out[0][1], -1.0, 1e-12);
  assert_close(out[0][2], 0.0, 4.0 / sqrt(N));
  assert_close(out[1][0], 0.0, 4.0 / sqrt(N));
  for (size_t i = 0; i < N; i++) value[3 * i] = 7.0;
  assert_int_equal(um_uncertainty_rank_correlation(context, N, 2, parameter, 3, value, *out),
                   UM_OK);
  assert_true(isnan(out[0][0]));
}

/* A prior uniform on [-5, 5] and a measurement of 1 +- 0.5: the posterior is that normal
 * distribution. A measurement of x at sigma s is worth 10 / (2 sqrt(pi) s) of.. the effective share
 * s 2 sqrt(pi) / 10 of the points: (int w)^2 / int w^2. */
static void test_weights(void **state)
{
  (void)state;
  double x[N], l[N], w[N], effective, mean, deviation, q[3], p[3] = {0.15865525, 0.5, 0.84134475};
  for (size_t i = 0; i < N; i++) {
    x[i] = -5.0 + 10.0 * ((double)i + 0.5) / N;
    l[i] = -1e5 - 0.5 * pow((x[i] - 1.0) / 0.5, 2.0);
  }
  assert_int_equal(um_uncertainty_weights(context, N, l, w, &effective), UM_OK);
  um_uncertainty_mean(N, 1, x, w, &mean, &deviation);
  assert_int_equal(um_uncertainty_quantiles(context, N, 1, x, w, 3, p, q), UM_OK);
  assert_close(mean, 1.0, 1e-9);
  assert_close(deviation, 0.5, 1e-9);
  assert_close(q[0], 0.5, 1e-3);
  assert_close(q[1], 1.0, 1e-3);
  assert_close(q[2], 1.5, 1e-3);
  assert_close(effective, N * 2.0 * sqrt(UM_PI) * 0.5 / 10.0, 1e-6 * N);
  l[0] = NAN;
  l[1] = -INFINITY;
  assert_int_equal(um_uncertainty_weights(context, N, l, w, &effective), UM_OK);
  assert_close(w[0] + w[1], 0.0, 0.0);
  l[2] = INFINITY;
  assert_int_equal(um_uncertainty_weights(context, N, l, w, &effective), UM_ERR_INPUT);
  um_core_message_clear(context);
  assert_int_equal(um_uncertainty_weights(context, 2, l, w, &effective), UM_ERR_INPUT);
  um_core_message_clear(context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_quantiles), cmocka_unit_test(test_mean_and_above),
      cmocka_unit_test(test_correlation), cmocka_unit_test(test_weights)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
