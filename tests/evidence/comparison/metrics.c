/* Metrics against numbers worked out by hand.
 *
 *   y 2 4 6 -1   m 1 4 8 0   sigma 1/2 1 2 1   r = y - m = 1 0 -2 -1   e = r/sigma = 2 0 -1 -1
 *
 * Tolerance 1e-15 relative: a few roundings of numbers near 1. */
#include "tests/evidence/metrics_test.h"

static const double measured[4] = {2.0, 4.0, 6.0, -1.0}, model[4] = {1.0, 4.0, 8.0, 0.0},
                    sigma[4] = {0.5, 1.0, 2.0, 1.0};

static struct um_compare_metrics compute(enum um_compare_quantity quantity, size_t count,
                                         const double *y, const double *m, const double *s,
                                         double fitted)
{
  struct um_compare_metrics all;
  assert_ok(metrics_of(quantity, count, y, m, s, NULL, NULL, 0, fitted, NULL, &all));
  return all;
}

static void test_by_hand(void **state)
{
  (void)state;
  struct um_compare_metrics a =
      compute(UM_QUANTITY_BAND_IRRADIANCE, 4, measured, model, sigma, 0.0);
  assert_int_equal(a.count, 4);
  assert_close(a.mean_measured, 2.75, 1e-15);
  assert_close(a.mean_model, 3.25, 1e-15);
  assert_close(a.bias, -0.5, 1e-15);
  assert_close(a.sd, sqrt(5.0 / 3.0), 1e-15); /* 1.5 0.5 -1.5 -0.5 */
  assert_close(a.rms, sqrt(1.5), 1e-15);      /* 1 + 0 + 4 + 1 over 4 */
  assert_close(a.rms_over_mean, sqrt(1.5) / 2.75, 1e-15);
  assert_close(a.median_ratio, 1.0, 1e-15);  /* of 2, 1, 3/4; the dark row has no ratio */
  assert_close(a.scale, 66.0 / 81.0, 1e-15); /* (2 + 16 + 48) / (1 + 16 + 64) */
  assert_close(a.rms_scaled, sqrt((57.0 - 66.0 * 66.0 / 81.0) / 4.0), 1e-15);
  assert_close(a.chi2, 6.0, 1e-15); /* 4 + 0 + 1 + 1 */
  assert_close(a.dof, 4.0, 0.0);
  assert_close(a.chi2_reduced, 1.5, 1e-15);
  assert_close(a.chi2_p, 4.0 * exp(-3.0), 1e-15);  /* dof 4: exp(-x/2) (1 + x/2) */
  assert_close(a.durbin_watson, 5.0 / 6.0, 1e-15); /* (4 + 1 + 0) / 6 */
  /* beta variate of mean 3/8 and variance 7/192 below 5/24, by quadrature of its density */
  double sum = 0.0, part = 0.0, p = 0.375 * (0.375 * 0.625 * 192.0 / 7.0 - 1.0),
         q = 0.625 * (0.375 * 0.625 * 192.0 / 7.0 - 1.0);
  for (int i = 0; i < 240000; i++) {
    double x = (i + 0.5) / 240000.0, density = pow(x, p - 1.0) * pow(1.0 - x, q - 1.0);
    sum += density;
    if (i < 50000) part += density;
  }
  assert_close(a.white_p, 2.0 * part / sum, 1e-8); /* midpoint rule: 1e-9 */
}

static void test_segments(void **state)
{
  (void)state;
  const double y[6] = {2.0, NAN, 4.0, 6.0, -1.0, 1.0}, m[6] = {1.0, 1.0, 4.0, 8.0, 0.0, 1.0};
  const double s[6] = {0.5, 1.0, 1.0, 2.0, 1.0, NAN};
  const size_t label[6] = {0, UM_COMPARE_LABEL_NONE, 0, 2, 2, 2};
  struct um_compare_metrics g[3], a;
  assert_ok(metrics_of(UM_QUANTITY_COUNT_RATE, 6, y, m, s, NULL, label, 3, 1.0, g, &a));
  assert_int_equal(a.count, 5);
  assert_close(a.bias, -0.4, 1e-15);
  assert_close(a.chi2, 6.0, 1e-15);
  assert_close(a.dof, 3.0, 1e-15); /* four rows have a sigma, one parameter */
  assert_close(a.chi2_reduced, 2.0, 1e-15);
  assert_close(a.durbin_watson, 7.0 / 6.0, 1e-15); /* of r 1 0 -2 -1 0: 1+4+1+1 over 6 */
  assert_int_equal(g[0].count, 2);
  assert_close(g[0].bias, 0.5, 1e-15);
  assert_close(g[0].dof, 1.5, 1e-15); /* its share of the parameter */
  assert_int_equal(g[1].count, 0);
  assert_true(isnan(g[1].rms) && isnan(g[1].chi2) && isnan(g[1].durbin_watson));
  assert_int_equal(g[2].count, 3);
  assert_close(g[2].bias, -1.0, 1e-15);
  assert_close(g[2].mean_measured, 2.0, 1e-15);
  assert_close(g[2].chi2, 2.0, 1e-15);
}

/* 2.5 mag is a factor 10; +infinity is no light. In magnitudes the first residual would be -2.5. */
static void test_magnitudes(void **state)
{
  (void)state;
  const double y[2] = {0.0, 2.5}, m[2] = {2.5, INFINITY}, s[2] = {0.1, 0.1};
  struct um_compare_metrics a = compute(UM_QUANTITY_MAGNITUDE_AB, 2, y, m, s, 0.0);
  double k = 0.1 / 1.0857362047581296; /* sigma of ln flux */
  assert_close(a.bias, 0.5, 1e-15);    /* 0.9 and 0.1 */
  assert_close(a.rms, sqrt(0.41), 1e-15);
  assert_close(a.median_ratio, 10.0, 1e-14);
  assert_close(a.chi2, (0.81 + 1.0) / (k * k), 1e-11);
}

/* Magnitudes 1 2 4 5 against 2 1 4 9: deviations from the means -2 -1 1 2 and -2 -3 0 5, so
 * r = (4 + 3 + 0 + 10)/sqrt(10 x 38). A row without light in the model is left out of it; an offset
 * in magnitudes, which is a scale of the flux, does not change it; other quantities have none. */
static void test_correlation(void **state)
{
  (void)state;
  const double y[5] = {1.0, 2.0, 3.0, 4.0, 5.0}, m[5] = {2.0, 1.0, INFINITY, 4.0, 9.0};
  double shifted[5];
  double r = 17.0 / sqrt(380.0);
  assert_close(compute(UM_QUANTITY_MAGNITUDE_AB, 5, y, m, NULL, 0.0).correlation, r, 1e-14);
  for (int i = 0; i < 5; i++) shifted[i] = m[i] - 0.7;
  assert_close(compute(UM_QUANTITY_MAGNITUDE_VEGA, 5, y, shifted, NULL, 0.0).correlation, r, 1e-14);
  assert_true(isnan(compute(UM_QUANTITY_MAGNITUDE_AB, 2, y, m, NULL, 0.0).correlation));
  const double constant[3] = {4.0, 4.0, 4.0};
  assert_true(isnan(compute(UM_QUANTITY_MAGNITUDE_AB, 3, y, constant, NULL, 0.0).correlation));
  assert_true(
      isnan(compute(UM_QUANTITY_BAND_IRRADIANCE, 4, measured, model, NULL, 0.0).correlation));
}

static void test_temperatures(void **state)
{
  (void)state;
  const double y[3] = {281.0, 280.0, 282.0}, m[3] = {280.0, 280.0, 280.0};
  struct um_compare_metrics a = compute(UM_QUANTITY_TEMPERATURE, 3, y, m, NULL, 0.0);
  assert_close(a.bias, 1.0, 1e-15);
  assert_close(a.sd, 1.0, 1e-15);
  assert_close(a.rms, sqrt(5.0 / 3.0), 1e-15);
  assert_true(isnan(a.rms_over_mean) && isnan(a.median_ratio) && isnan(a.scale));
  assert_true(isnan(a.rms_scaled) && isnan(a.chi2) && isnan(a.chi2_reduced) && isnan(a.dof));
}

static void test_edges(void **state)
{
  (void)state;
  const double one = -2.0, dark = 0.0, bright = 4.0, s = 0.5;
  struct um_compare_metrics a = compute(UM_QUANTITY_BAND_IRRADIANCE, 1, &one, &bright, &s, 0.0);
  assert_close(a.bias, -6.0, 0.0);
  assert_close(a.rms, 6.0, 0.0);
  assert_true(isnan(a.sd) && isnan(a.rms_over_mean) && isnan(a.durbin_watson));
  assert_close(a.median_ratio, -0.5, 0.0);
  assert_close(a.rms_scaled, 0.0, 0.0);
  assert_close(a.chi2_reduced, 144.0, 0.0);
  a = compute(UM_QUANTITY_BAND_IRRADIANCE, 1, &one, &dark, &s, 1.0);
  assert_true(isnan(a.scale) && isnan(a.rms_scaled) && isnan(a.median_ratio));
  assert_true(a.dof == 0.0 && isnan(a.chi2_reduced) &&
              isnan(a.chi2_p)); /* one row, one parameter */
  a = compute(UM_QUANTITY_BAND_IRRADIANCE, 0, NULL, NULL, NULL, 0.0);
  assert_true(a.count == 0 && isnan(a.bias));
  /* a perfect model: chi-square 0, no whiteness to speak of */
  a = compute(UM_QUANTITY_BAND_IRRADIANCE, 4, model, model, sigma, 0.0);
  assert_true(a.chi2 == 0.0 && a.chi2_p == 1.0 && isnan(a.white_p) && a.scale == 1.0);
}

/* One row k sigma off: P = erfc(k / sqrt 2); two rows, dof 2: P = exp(-chi2 / 2). Far tails are 0
 * and not an abort. Library accuracy about 1e-12 where exp itself loses chi2 x 1e-16. */
static void test_tails(void **state)
{
  (void)state;
  const double zero[2] = {0.0, 0.0}, s[2] = {1.0, 1.0};
  for (int k = 1; k <= 60; k++) {
    double y[2] = {k, k};
    double p = compute(UM_QUANTITY_COUNT_RATE, 1, y, zero, s, 0.0).chi2_p;
    assert_close(p, erfc(k / sqrt(2.0)), 1e-11 * p + 1e-300);
    p = compute(UM_QUANTITY_COUNT_RATE, 2, y, zero, s, 0.0).chi2_p;
    assert_close(p, exp(-k * k), 1e-11 * p + 1e-300);
  }
  for (double k = 1e-160; k < 1e155; k *= 7.0) {
    double y[2] = {k, -k};
    struct um_compare_metrics a = compute(UM_QUANTITY_COUNT_RATE, 2, y, zero, s, 0.0);
    assert_true(a.chi2_p >= 0.0 && a.chi2_p <= 1.0);
  }
}

/* The model's own error in quadrature: sigma 3, 4, none and model 4, 3, 1 make both s = 5, so that
 * residuals of 5 and -10 have chi-square 1 + 4; shares 16/25 and 9/25; whiteness takes r without
 * sigma, as before. */
static void test_model_sigma(void **state)
{
  (void)state;
  const double y[3] = {5.0, -10.0, 7.0}, m[3] = {0}, s[3] = {3.0, 4.0, NAN},
               own[3] = {4.0, 3.0, 1.0};
  struct um_compare_metrics a, without;
  assert_ok(metrics_of(UM_QUANTITY_TEMPERATURE, 3, y, m, s, own, NULL, 0, 0.0, NULL, &a));
  assert_close(a.chi2, 5.0, 1e-14);
  assert_close(a.dof, 2.0, 1e-15);
  assert_close(a.model_share, 0.5, 1e-15);
  assert_ok(metrics_of(UM_QUANTITY_TEMPERATURE, 3, y, m, s, NULL, NULL, 0, 0.0, NULL, &without));
  assert_close(without.chi2, 25.0 / 9.0 + 100.0 / 16.0, 1e-14);
  assert_close(without.model_share, 0.0, 0.0);
  assert_close(without.durbin_watson, a.durbin_watson, 1e-15);
  /* all with a sigma: (1, -2) has (3^2) / (1 + 4) */
  assert_ok(metrics_of(UM_QUANTITY_TEMPERATURE, 2, y, m, s, own, NULL, 0, 0.0, NULL, &a));
  assert_true(isnan(a.durbin_watson)); /* two observations */
  const double four[4] = {5.0, -10.0, 5.0, -10.0}, zero[4] = {0}, s4[4] = {3, 4, 3, 4},
               own4[4] = {4, 3, 4, 3};
  assert_ok(metrics_of(UM_QUANTITY_TEMPERATURE, 4, four, zero, s4, own4, NULL, 0, 0.0, NULL, &a));
  assert_close(a.durbin_watson, 27.0 / 10.0, 1e-14);
  assert_refused(metrics_of(UM_QUANTITY_TEMPERATURE, 2, y, m, s, (const double[2]){1.0, -1.0}, NULL,
                            0, 0.0, NULL, &a),
                 UM_ERR_NUMERIC,
                 "metrics: observation 2: standard error of the model -1; accepted: 0 or more");
}

/* Metrics of magnitudes in magnitudes: residuals 0.3, -0.1 and one of a model without light, which
 * has no magnitude; bias 0.1, rms sqrt((0.09 + 0.01) / 2). Other quantities have none. */
static void test_in_magnitudes(void **state)
{
  (void)state;
  const double y[3] = {5.3, 6.9, 8.0}, m[3] = {5.0, 7.0, INFINITY};
  struct um_compare_metrics a = compute(UM_QUANTITY_MAGNITUDE_AB, 3, y, m, NULL, 0.0);
  assert_close(a.bias_mag, 0.1, 1e-14);
  assert_close(a.rms_mag, sqrt(0.05), 1e-14);
  assert_int_equal(a.count, 3);
  a = compute(UM_QUANTITY_COUNT_RATE, 2, y, m, NULL, 0.0);
  assert_true(isnan(a.bias_mag) && isnan(a.rms_mag));
}

static void test_refusals(void **state)
{
  (void)state;
  struct um_compare_metrics a, g[2];
  const double y[2] = {1.0, NAN}, m[2] = {1.0, 1.0}, s[2] = {1.0, 0.0}, minus[2] = {-INFINITY, 1};
  const size_t label[2] = {0, 2};
  assert_refused(metrics_of(UM_QUANTITY_COUNT_RATE, 2, y, m, NULL, NULL, NULL, 0, 0.0, NULL, &a),
                 UM_ERR_NUMERIC,
                 "metrics: observation 2: measured nan, model 1 1/s; accepted: finite numbers");
  assert_refused(metrics_of(UM_QUANTITY_COUNT_RATE, 2, m, y, NULL, NULL, NULL, 0, 0.0, NULL, &a),
                 UM_ERR_NUMERIC,
                 "metrics: observation 2: measured 1, model nan 1/s; accepted: finite numbers");
  assert_refused(
      metrics_of(UM_QUANTITY_MAGNITUDE_AB, 2, m, minus, NULL, NULL, NULL, 0, 0.0, NULL, &a),
      UM_ERR_NUMERIC,
      "metrics: observation 1: measured 0.398107, model inf flux of magnitude 0; accepted: "
      "finite numbers");
  assert_refused(metrics_of(UM_QUANTITY_TEMPERATURE, 2, m, m, s, NULL, NULL, 0, 0.0, NULL, &a),
                 UM_ERR_NUMERIC,
                 "metrics: observation 2: sigma 0 K; accepted: above 0, or NaN for none");
  assert_refused(metrics_of(UM_QUANTITY_TEMPERATURE, 2, m, m, NULL, NULL, label, 2, 0.0, g, &a),
                 UM_ERR_INPUT, "metrics: observation 2: segment 2; accepted: 0 to 1");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_by_hand),       cmocka_unit_test(test_segments),
      cmocka_unit_test(test_magnitudes),    cmocka_unit_test(test_temperatures),
      cmocka_unit_test(test_correlation),   cmocka_unit_test(test_edges),
      cmocka_unit_test(test_tails),         cmocka_unit_test(test_model_sigma),
      cmocka_unit_test(test_in_magnitudes), cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
