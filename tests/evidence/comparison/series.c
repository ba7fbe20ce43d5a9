/* Noise model, linear flux, series of a channel, folding. Numbers by hand: 2.5 mag is a factor 10,
 * and 2.5 / ln 10 = 1.0857362047581296. */
#include "evidence/comparison/series.h"

#include "evidence/measurements/measurements.h"
#include "evidence/measurements/noise.h"
#include "tests/evidence/compare_test.h"

static const char text[] = "time_utc,quantity,of,value,sigma,flag,track\n"
                           "2016-09-21T20:36:42Z,magnitude_ab,V,2.5,0.1,0,b\n"
                           "2016-09-21T20:36:40Z,magnitude_ab,V,0,0.2,0,a\n"
                           "2016-09-21T20:36:41Z,magnitude_ab,V,7.5,0.1,1,a\n"
                           "2016-09-21T20:36:41Z,temperature,bus,280,,0,a\n"
                           "2016-09-21T20:36:43Z,magnitude_ab,V,5,0.1,0,a\n"
                           "2016-09-21T20:36:43Z,temperature,bus,300,2,0,a\n";

static struct um_compare_measurements *read_text(void)
{
  struct um_compare_measurements *m;
  put("m.csv", text);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  return m;
}

static void test_linear(void **state)
{
  (void)state;
  struct um_compare_linear f = um_compare_linear(UM_QUANTITY_MAGNITUDE_VEGA, 2.5, 0.1);
  assert_close(f.value, 0.1, 1e-16);
  assert_close(f.sigma, 0.1 * 0.1 / 1.0857362047581296, 1e-17);
  f = um_compare_linear(UM_QUANTITY_MAGNITUDE_AB, INFINITY, NAN);
  assert_true(f.value == 0.0 && isnan(f.sigma));
  f = um_compare_linear(UM_QUANTITY_COUNT_RATE, -3.0, 2.0);
  assert_true(f.value == -3.0 && f.sigma == 2.0);
}

static void test_noise(void **state)
{
  (void)state;
  struct um_compare_noise noise = {0.03, 4.0};
  assert_close(um_compare_noise_sigma(UM_QUANTITY_COUNT_RATE, &noise, 100.0), 5.0, 1e-14);
  assert_close(um_compare_noise_sigma(UM_QUANTITY_COUNT_RATE, &noise, -100.0), 5.0, 1e-14);
  noise = (struct um_compare_noise){0.1, 0.0};
  assert_close(um_compare_noise_sigma(UM_QUANTITY_MAGNITUDE_AB, &noise, 7.0), 0.10857362047581296,
               1e-15);
  struct um_compare_measurements *m = read_text();
  double model[6] = {0, 0, 0, 30, 0, 40};
  noise = (struct um_compare_noise){0.1, 4.0};
  assert_ok(um_compare_noise_fill(context, m, 1, &noise, model));
  assert_close(m->row[3].sigma, 5.0, 1e-14); /* of the model */
  assert_true(m->row[5].sigma == 2.0);       /* the file's own stays */
  m->row[3].sigma = NAN;
  noise = (struct um_compare_noise){0.01, 0.0};
  assert_ok(um_compare_noise_fill(context, m, 1, &noise, NULL));
  assert_close(m->row[3].sigma, 2.8, 1e-14); /* of the measured value */
  m->row[3].sigma = m->row[5].sigma = NAN;
  model[5] = 0.0;
  assert_refused(
      um_compare_noise_fill(context, m, 1, &noise, model), UM_ERR_INPUT,
      "m.csv:7: the noise model gives temperature 'bus' of 0 K a sigma of 0 K; accepted: "
      "above 0 (give the noise a floor)");
  assert_true(isnan(m->row[3].sigma)); /* nothing half-filled */
  noise = (struct um_compare_noise){-0.1, 1.0};
  assert_refused(um_compare_noise_fill(context, m, 1, &noise, NULL), UM_ERR_INPUT,
                 "noise of temperature 'bus': relative -0.1, floor 1 K; accepted: both 0 or more, "
                 "not both 0");
  um_compare_measurements_destroy(context, &m);
}

static void test_series(void **state)
{
  (void)state;
  struct um_compare_measurements *m = read_text();
  struct um_compare_series *s;
  assert_ok(um_compare_series_create(context, m, 0, SIZE_MAX, &s));
  assert_int_equal(s->count, 3); /* the flagged row is left out; tracks are merged in time */
  assert_int_equal(s->row[0], 1);
  assert_int_equal(s->row[1], 0);
  assert_int_equal(s->row[2], 4);
  assert_close(s->value[1], 0.1, 1e-16);
  assert_close(s->value[2], 0.01, 1e-17);
  assert_close(s->sigma[0], 0.2 / 1.0857362047581296, 1e-15);
  /* errors in magnitudes follow the flux: 0.2 mag counts a quarter of 0.1 mag at any brightness */
  assert_close(s->weight[0] / s->weight[1], 0.25, 1e-14);
  assert_close(s->weight[2] / s->weight[1], 1.0, 1e-14);
  um_compare_series_destroy(context, &s);
  assert_null(s);
  assert_ok(um_compare_series_create(context, m, 0, 0, &s)); /* track b */
  assert_int_equal(s->count, 1);
  um_compare_series_destroy(context, &s);
  assert_ok(um_compare_series_create(context, m, 1, SIZE_MAX, &s));
  assert_int_equal(s->count, 2);
  assert_null(s->sigma); /* one row has none */
  um_compare_series_destroy(context, &s);
  um_compare_series_destroy(context, NULL);
  um_compare_measurements_destroy(context, &m);
}

static void test_fold(void **state)
{
  (void)state;
  double t[5] = {10.0, 11.0, 12.5, 13.999, 6.0}; /* the last a period before the epoch */
  /* bins of half a turn: {10, 11, 6} and {12.5, 13.999} */
  double value[5] = {1.0, 3.0, 7.0, 9.0, -1.0}, sigma[5] = {1.0, 0.5, 1.0, 1.0, 1.0};
  struct um_compare_series s = {.count = 5, .t = t, .value = value};
  struct um_compare_fold_bin bin[3];
  um_compare_fold_bins(&s, 4.0, 10.0, 2, bin);
  assert_int_equal(bin[0].count, 3);
  assert_close(bin[0].mean, 1.0, 1e-15);
  assert_close(bin[0].sigma, sqrt(8.0 / 2.0 / 3.0), 1e-15); /* scatter 0, 2, -2 */
  assert_close(bin[1].mean, 8.0, 1e-15);
  assert_close(bin[1].sigma, 1.0, 1e-15);
  s.sigma = sigma;
  um_compare_fold_bins(&s, 4.0, 10.0, 2, bin);
  assert_close(bin[0].mean, (1.0 + 4.0 * 3.0 - 1.0) / 6.0, 1e-15);
  assert_close(bin[0].sigma, sqrt(1.0 / 6.0), 1e-15);
  s.count = 1;
  s.sigma = NULL;
  um_compare_fold_bins(&s, 4.0, 10.0, 3, bin);
  assert_int_equal(bin[0].count, 1);
  assert_true(isnan(bin[0].sigma) && isnan(bin[1].mean));
  /* so little before the epoch that the fraction rounds to 1: the first bin, not one after the last
   */
  t[0] = -1e-17;
  um_compare_fold_bins(&s, 4.0, 0.0, 2, bin);
  assert_int_equal(bin[0].count, 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_linear), cmocka_unit_test(test_noise),
                                     cmocka_unit_test(test_series), cmocka_unit_test(test_fold)};
  return cmocka_run_group_tests(tests, compare_set_up, compare_tear_down);
}
