/* Points of a study against measurements made of one of its models. */
#include "study/measured.h"

#include <stdio.h>
#include <unistd.h>

#include "base/core/sampling.h"
#include "orbit/time.h"
#include "study/per_point.h"
#include "tests/base/inference/observations_test.h"
#include "tests/study/pass_test.h"
#include "tests/support/temporary.h"

static const double truth[3] = {0.82, 350.0, 1.0};

/* Infrared irradiance at 60 times, sigma a share of its largest value, and the temperature of the
 * bus at three; noise keyed. Some rows that cannot count: flagged, too early, without sigma. */
static void write_measurements(char path[UM_TEST_PATH], double sigma, const char *more)
{
  static char text[20000];
  double v[PASS_NVALUE];
  size_t used = (size_t)snprintf(text, sizeof text, "time_utc,quantity,of,value,sigma,flag\n");
  pass_values(truth, v);
  for (size_t i = 0; i < 60; i++) {
    char time[32];
    size_t k = 2 * i + 1;
    um_orbit_time_format(5.2783e8 + 6.0 * (double)k + 3.0, time); /* between two instants */
    double at = 0.5 * (v[PASS_NTIME + k] + v[PASS_NTIME + k + 1]), s = sigma * 2e-10;
    used +=
        (size_t)snprintf(text + used, sizeof text - used, "%s,band_irradiance,lwir,%.9g,%.9g,%d\n",
                         time, at + s * rows_normal(3, i), s, i == 7 ? 1 : 0);
  }
  snprintf(text + used, sizeof text - used, "%s", more);
  um_test_file_create(path, text, strlen(text));
}

/* The posterior finds the truth within its own width, is narrower than the prior where the
 * measurements say something, and as wide where they do not (the blankets). */
static void test_posterior(void **state)
{
  (void)state;
  char path[UM_TEST_PATH];
  struct um_study_measured *m;
  struct um_study_result *r = pass_sobol(8192, true);
  size_t nvalue = r->nvalue;
  for (size_t k = 0; k < nvalue; k++) r->value[11 * nvalue + k] = NAN;
  assert_int_equal(um_core_strdup(context, "a thermostat", &r->reason[11]), UM_OK);
  write_measurements(path, 0.01,
                     "2016-09-22T15:38:02Z,temperature,bus,270,,0\n"
                     "2016-09-22T15:50:00Z,band_irradiance,lwir,1e-10,1e-12,0\n");
  if (um_study_measured_create(context, r, path, &m) != UM_OK)
    fail_msg("%s", um_core_message(context));
  assert_int_equal(m->used, 59);
  assert_int_equal(m->left_out, 3);
  double mean[3], deviation[3], sum = 0.0;
  for (size_t p = 0; p < r->npoint; p++) sum += m->weight[p];
  assert_close(sum, 1.0, 1e-12);
  assert_true(isnan(m->chi2[11]) && m->weight[11] == 0.0);
  assert_true(m->effective > 20.0 && m->effective < 4000.0);
  for (size_t i = 0; i < 3; i++) {
    mean[i] = deviation[i] = 0.0;
    for (size_t p = 0; p < r->npoint; p++) mean[i] += m->weight[p] * r->parameter[3 * p + i];
    for (size_t p = 0; p < r->npoint; p++)
      deviation[i] += m->weight[p] * pow(r->parameter[3 * p + i] - mean[i], 2.0);
    deviation[i] = sqrt(deviation[i]);
    print_message("%s %.4g +- %.2g\n", r->parameter_name[i], mean[i], deviation[i]);
    assert_close(mean[i], truth[i], 3.0 * deviation[i]);
  }
  assert_true(deviation[0] < 0.01);                        /* before 0.2 / sqrt(12) = 0.058 */
  assert_true(deviation[1] < 60.0);                        /* 173 */
  assert_true(deviation[2] > 0.08 && deviation[2] < 0.12); /* 0.1 */
  /* chi-square of the best is that of noise: 59 rows, 3 parameters, 3 sigma of 56 */
  assert_close(m->chi2[m->best], 56.0, 3.0 * sqrt(2.0 * 56.0));
  assert_int_equal(r->nvalue, nvalue + 4);
  const struct um_study_quantity *rms = um_study_result_quantity(r, "rms:irradiance:lwir");
  assert_non_null(rms);
  assert_close(um_study_result_values(r, m->best, rms)[0], 2e-12, 0.6e-12);
  /* statistics cope with values that the surrogate has not */
  struct um_study_statistics *l;
  assert_int_equal(um_study_statistics_create(context, r, NULL, &l), UM_OK);
  assert_true(isnan(l->first[rms->first]) && isfinite(l->correlation[rms->first]));
  assert_close(l->first[PASS_NTIME + 20], 0.93, 0.05);
  um_study_statistics_destroy(context, &l);
  assert_int_equal(um_study_measured_print(context, r, m, stdout), UM_OK);
  um_study_measured_destroy(context, &m);
  um_study_result_destroy(context, &r);
  unlink(path);
}

static void refused(struct um_study_result *r, const char *more, const char *word)
{
  char path[UM_TEST_PATH];
  struct um_study_measured *m;
  write_measurements(path, 0.01, more);
  assert_int_equal(um_study_measured_create(context, r, path, &m), UM_ERR_INPUT);
  assert_null(m);
  if (strstr(um_core_message(context), word) == NULL)
    fail_msg("'%s' does not say '%s'", um_core_message(context), word);
  um_core_message_clear(context);
  unlink(path);
}

static void test_refusals(void **state)
{
  (void)state;
  struct um_study_result *r = pass_sobol(16, false);
  refused(r, "2016-09-22T15:38:02Z,band_irradiance,nir,1e-10,1e-12,0\n", "'nir' is measured");
  refused(r, "2016-09-22T15:38:02Z,count_rate,lwir,10,1,0\n", "can be compared");
  refused(r, "2016-09-22T15:38:02Z,temperature,bus,-3,1,0\n", "");
  for (size_t k = 0; k < PASS_NTIME; k++) r->nominal[PASS_NTIME + k] = NAN;
  refused(r, "", "no row has a sigma");
  r->design = UM_STUDY_MORRIS;
  refused(r, "", "no sample of the parameters");
  um_study_result_destroy(context, &r);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_posterior),
                                     cmocka_unit_test(test_refusals)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
