/* Whiteness of a residual: p under white noise, power against what is not. */
#include "base/inference/score.h"

#include "tests/base/inference/observations_test.h"
#include "tests/support/with_context.h"

#define ROWS 200

/* Noise with correlation `memory` of neighbours in channels 0 and 1, observations taking turns;
 * channel 2 has 3 observations, too few to say anything. */
static struct um_inference_whiteness draw(struct um_context *c, uint64_t key, double memory)
{
  struct um_inference_whiteness w;
  double r[ROWS + 3], last[2] = {rows_normal(key, 1000), rows_normal(key, 1001)};
  size_t channel[ROWS + 3];
  for (size_t i = 0; i < ROWS + 3; i++) {
    channel[i] = i < ROWS ? i % 2 : 2;
    r[i] = rows_normal(key, i);
    if (i >= ROWS) continue;
    r[i] = last[i % 2] = memory * last[i % 2] + sqrt(1.0 - memory * memory) * r[i];
  }
  assert_int_equal(um_inference_whiteness_test(c, ROWS + 3, r, channel, 3, 3.0, &w), UM_OK);
  return w;
}

/* 5 % of white draws below 0.05 and 1 % below 0.01, within 4 standard errors of 4000 draws (0.0138
 * and 0.0063). Q follows chi-square to order 1/n only: with 100 observations and 10 lags its tail
 * at 1 % is known to be up to half too thick (Ljung & Box 1978, table 1), which is the 0.005 added.
 */
static void test_size(void **state)
{
  struct um_context *c = *state;
  double five = 0.0, one = 0.0, chi2 = 0.0;
  const uint64_t draws = 4000;
  for (uint64_t k = 0; k < draws; k++) {
    struct um_inference_whiteness w = draw(c, um_core_hash(21, k), 0.0);
    five += w.p_white < 0.05;
    one += w.p_white < 0.01;
    chi2 += w.p_chi2 < 0.05;
  }
  assert_close(five / (double)draws, 0.05, 0.0138 + 0.005);
  assert_close(one / (double)draws, 0.01, 0.0063 + 0.005);
  /* three parameters that were not fitted: P(chi2_203 > the 5 % point of chi2_200) = 0.0669 */
  assert_close(chi2 / (double)draws, 0.0669, 0.0158);
}

/* A correlation of 0.7 over 100 observations: Q has the mean 10 + 100 (0.49 + 0.24 + ..) = 106 per
 * channel, and 37.6 of both is the 1 % point. Its scatter is of the order of a third, so that a
 * draw or two of 50 may be missed. */
static void test_power(void **state)
{
  size_t found = 0;
  for (uint64_t k = 0; k < 50; k++) found += draw(*state, um_core_hash(22, k), 0.7).p_white < 0.01;
  assert_true(found >= 48);
}

/* P(chi2_10 > 18.307) = 0.05, of any table; an alternating residual has rho_k = +-1. */
static void test_values(void **state)
{
  struct um_context *c = *state;
  struct um_inference_whiteness w;
  double r[1000];
  size_t channel[1000] = {0};
  for (size_t i = 0; i < 1000; i++) r[i] = sqrt(1.8307) * (i % 2 == 0 ? 1.0 : -1.0);
  assert_int_equal(um_inference_whiteness_test(c, 10, r, channel, 1, 0.0, &w), UM_OK);
  assert_close(w.chi2, 18.307, 1e-12);
  assert_close(w.dof, 10.0, 0.0);
  assert_close(w.p_chi2, 0.05, 1e-5); /* 18.307 has five digits */
  /* n = 10, two lags: rho_1 = -0.9, rho_2 = 0.8, Q = 120 (0.81 / 9 + 0.64 / 8) = 20.4, of two
   * degrees of freedom: exp(-Q / 2); Fisher of one channel is that p again */
  assert_close(w.p_white, exp(-10.2), 1e-15);
  assert_int_equal(um_inference_whiteness_test(c, 1000, r, channel, 1, 0.0, &w), UM_OK);
  assert_true(w.p_white < 1e-300);
  assert_int_equal(um_inference_whiteness_test(c, 4, r, channel, 1, 0.0, &w), UM_OK);
  assert_close(w.p_white, 1.0, 0.0); /* too few to speak against it */
  /* 100 observations that fit exactly and ten that do not: 18.307 among two channels, 1 - 0.95^2 */
  double both[110];
  size_t of[110];
  for (size_t i = 0; i < 110; i++) both[i] = i < 100 ? (i % 2 == 0 ? 0.9 : -0.9) : r[i];
  for (size_t i = 0; i < 110; i++) of[i] = i >= 100;
  assert_int_equal(um_inference_whiteness_test(c, 110, both, of, 2, 0.0, &w), UM_OK);
  assert_close(w.worst, 1.8307, 1e-12);
  assert_close(w.p_worst, 0.0975, 2e-5);
  assert_true(w.p_chi2 > 0.7);
  r[3] = NAN;
  assert_int_equal(um_inference_whiteness_test(c, 10, r, channel, 1, 0.0, &w), UM_OK);
  assert_true(isnan(w.p_white) && isnan(w.p_chi2));
  assert_int_equal(um_inference_whiteness_test(c, 3, r, channel, 1, 3.0, &w), UM_OK);
  assert_true(isnan(w.p_chi2)); /* nothing is left to judge by */
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_values), cmocka_unit_test(test_size),
                                     cmocka_unit_test(test_power)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
