/* Error bars of a forecast against samples of real runs: parameters at the three points of
 * Gauss-Hermite's rule, whose weighted mean squares are those of a normal distribution up to the
 * fifth power, so that the bars of a smooth answer are the standard deviations of the sample. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "forecast/forecast_impl.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/forecast/box_test.h"

/* A box that a wing shades, out of the umbra. */
static const char scenario[] = BOX("2016-09-06T18:09:00Z", "2016-09-06T18:13:00Z");

enum { NBAND = 2, NPLACE = 2, TOLD = NBAND + NPLACE, MOST = 3 };
static const size_t place[NPLACE] = {0, 1};
static const bool thermal[NBAND] = {false, true};
static const char *const periodic[] = {
    "thermal.start=periodic", "thermal.orbits_before=1",
    "thermal.accuracy_K=0.001"}; /* bends by 3 mK are looked at */
static char path[UM_TEST_PATH];

static int set_up(void **state)
{
  um_test_file_create(path, scenario, sizeof scenario - 1);
  return context_set_up(state);
}

static int tear_down(void **state)
{
  unlink(path);
  return context_tear_down(state);
}

/* A parameter as a forecast is told of it, and how a run takes a value of it. */
struct asked {
  const char *uncertain; /* "..=sigma" */
  const char *option;    /* "..=%.17g" */
  bool is_key;
  double value, sigma;
};

static size_t nvalue(void) { return um_forecast_values(NBAND, NPLACE); }

/* A pass that is the scenario's own window, with error bars: *record, the caller's to free. */
static void forecast(const char *const *keys, size_t nkey, const struct asked *asked, size_t n,
                     bool checked, double **record)
{
  const struct um_model_options options = {.overrides = keys, .noverride = nkey};
  struct um_forecast_work work = {
      .nband = NBAND, .nplace = NPLACE, .place = place, .thermal = thermal};
  const char *text[MOST] = {NULL};
  struct um_model *model;
  OK(um_model_create(context, path, &options, &model));
  const double start = model->scenario->time->start, stop = start + 240.0;
  const struct um_model_instants instant = {.time = &start, .count = 1};
  const struct um_variant_settings settings = {.instants = &instant, .base = {1.0, 0.01}};
  OK(um_variant_evaluator_create(context, model, &settings, &work.evaluator));
  work.model = model;
  work.checked = checked ? start : -1.0;
  for (size_t i = 0; i < n; i++) text[i] = asked[i].uncertain;
  OK(um_forecast_uncertain_read(context, &work, text, n, &work.unknowns));
  assert_int_equal(work.unknowns.n, n);
  OK(um_core_allocate(context, um_forecast_record(&work), sizeof **record, record));
  const double at[UM_FORECAST_COORDINATES] = {0.0, start, stop, start + 120.0};
  OK(um_forecast_compute(context, &work, at, *record));
  assert_true(um_forecast_accepts(&work, at, *record));
  um_forecast_uncertain_clear(context, &work.unknowns);
  um_variant_evaluator_destroy(context, &work.evaluator);
  um_model_destroy(context, &model);
}

/* A real run with parameters at values, and what a forecast keeps of it [nvalue]. */
static void run(const char *const *keys, size_t nkey, const struct asked *asked, size_t n,
                const double *at, double *value)
{
  char text[MOST][128];
  const char *key[MOST + 3], *with[MOST];
  struct um_forecast_work work = {.nband = NBAND, .nplace = NPLACE, .place = place};
  struct um_model_options options = {.overrides = key, .noverride = nkey, .with = with};
  struct um_variant v = {0};
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
  for (size_t i = 0; i < nkey; i++) key[i] = keys[i];
  for (size_t i = 0; i < n; i++) {
    snprintf(text[i], sizeof text[i], "%s=%.17g", asked[i].option, at[i]);
    if (asked[i].is_key)
      key[options.noverride++] = text[i];
    else
      with[options.nwith++] = text[i];
  }
  OK(um_model_create(context, path, &options, &model));
  OK(um_model_precompute(context, model, &tables));
  OK(um_model_run(context, model, tables, &result));
  v.model = model;
  v.tables = tables;
  um_forecast_store(&work, &v, result, model->scenario->time->start + 120.0, value);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

/* Weighted mean and variance [nvalue] over all combinations of the three points. */
static void sample(const char *const *keys, size_t nkey, const struct asked *asked, size_t n,
                   double *mean, double *variance)
{
  static const double node[3] = {-1.7320508075688772, 0.0, 1.7320508075688772},
                      weight[3] = {1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0};
  size_t count = 1;
  double *value;
  for (size_t i = 0; i < n; i++) count *= 3;
  OK(um_core_allocate(context, nvalue(), sizeof *value, &value));
  memset(mean, 0, nvalue() * sizeof *mean);
  memset(variance, 0, nvalue() * sizeof *variance);
  for (size_t s = 0; s < count; s++) {
    double at[MOST], of = 1.0;
    for (size_t i = 0, rest = s; i < n; i++, rest /= 3) {
      at[i] = asked[i].value + asked[i].sigma * node[rest % 3];
      of *= weight[rest % 3];
    }
    run(keys, nkey, asked, n, at, value);
    for (size_t k = 0; k < nvalue(); k++) {
      mean[k] += of * value[k];
      variance[k] += of * value[k] * value[k];
    }
  }
  for (size_t k = 0; k < nvalue(); k++) variance[k] -= mean[k] * mean[k];
  print_message("%zu runs\n", count);
  um_core_free(context, value);
}

/* Where values stand that have an error bar: of bands, places, curves. */
static bool has_bar(size_t k)
{
  const size_t band = sizeof(struct um_forecast_band) / sizeof(double), places = 1 + NBAND * band,
               curves = places + 3 * NPLACE + UM_FORECAST_CURVE;
  if (k == 0) return false;
  if (k >= places) return k < places + 3 * NPLACE || k >= curves;
  switch ((k - 1) % band) { /* of struct um_forecast_band: times, and the error of rays */
  case 1:
  case 4:
  case 7:
    return false;
  default:
    return true;
  }
}

/* The lowest and the highest temperature: where another instant takes over, they have a kink. */
static bool is_extreme(size_t k)
{
  const size_t places = 1 + NBAND * sizeof(struct um_forecast_band) / sizeof(double);
  return k >= places && k < places + 3 * NPLACE && (k - places) % 3 > 0;
}

/* Bars against the sample's standard deviations: to a share, and to `least` of the value, which is
 * what the subtraction of mean squares and the noise of integrations leave. */
static void compare(const double *record, const double *mean, const double *variance, double share,
                    double least, size_t fewest)
{
  const double *sigma = record + nvalue();
  double worst = 0.0;
  size_t bars = 0;
  for (size_t k = 0; k < nvalue(); k++) {
    if (!has_bar(k)) {
      assert_true(isnan(sigma[k]));
      continue;
    }
    double deviation = sqrt(fmax(variance[k], 0.0)), floor = least * fabs(mean[k]);
    assert_true(sigma[k] >= 0.0);
    if (deviation < floor / share) {
      assert_true(sigma[k] < 2.0 * floor / share);
      continue;
    }
    bars++;
    double of = is_extreme(k) ? 5.0 * share : share;
    assert_close(sigma[k] / deviation, 1.0, of);
    if (of > share) continue;
    worst = fmax(worst, fabs(sigma[k] / deviation - 1.0));
  }
  print_message("%zu bars within %.2g of the sample's\n", bars, worst);
  assert_true(bars >= fewest);
}

/* Two parameters of a material and a key, by one run of sensitivities. */
static void test_sample(void **state)
{
  (void)state;
  static const struct asked asked[] = {
      {"emittance:grey_white=0.03", "emittance:grey_white,factor", false, 1.0, 0.03},
      {"solar_absorptance:grey_white,shift=0.02", "solar_absorptance:grey_white,shift", false, 0.0,
       0.02},
      {"parts.bus.shell.areal_heat_capacity_J_m2_K=150",
       "parts.bus.shell.areal_heat_capacity_J_m2_K", true, 3000.0, 150.0}};
  double *record, *mean, *plain;
  OK(um_core_allocate(context, 2 * nvalue(), sizeof *mean, &mean));
  forecast(NULL, 0, asked, 3, false, &record);
  sample(NULL, 0, asked, 3, mean, mean + nvalue());
  compare(record, mean, mean + nvalue(), 0.01, 1e-6, 250);
  /* what is predicted does not move */
  forecast(NULL, 0, NULL, 0, false, &plain);
  assert_memory_equal(plain, record, nvalue() * sizeof *plain);
  /* squares of the parts are that of the bar, and each is a parameter's own */
  const double *part = record + 2 * nvalue(), *sigma = record + nvalue();
  const size_t bus = 1 + NBAND * sizeof(struct um_forecast_band) / sizeof(double);
  double sum = 0.0;
  for (size_t i = 0; i < 3; i++) sum += part[i * TOLD + NBAND] * part[i * TOLD + NBAND];
  assert_close(sqrt(sum) / sigma[bus], 1.0, 1e-12);
  assert_true(part[NBAND] < 0.0 && part[TOLD + NBAND] > 0.0 && part[2 * TOLD + NBAND] > 0.0);
  for (size_t i = 0; i < 3; i++) assert_true(isnan(part[3 * TOLD + i * TOLD + NBAND]));
  um_core_free(context, plain);
  um_core_free(context, record);
  um_core_free(context, mean);
}

/* From a periodic start, one of which moves the loads. */
static void test_periodic(void **state)
{
  (void)state;
  static const struct asked asked[] = {
      {"earth_ir_level=0.05", "earth_ir_level,factor", false, 1.0, 0.05},
      {"emittance:grey_white=0.03", "emittance:grey_white,factor", false, 1.0, 0.03}};
  double *record, *mean;
  OK(um_core_allocate(context, 2 * nvalue(), sizeof *mean, &mean));
  forecast(periodic, 3, asked, 2, false, &record);
  sample(periodic, 3, asked, 2, mean, mean + nvalue());
  compare(record, mean, mean + nvalue(), 0.03, 1e-5, 120);
  um_core_free(context, record);
  um_core_free(context, mean);
}

/* What turns the body is traced and solved anew, looked at by the same points. Where a shadow's
 * edge goes over them, light jumps by some thousandths: bars below that are not held against
 * anything. */
static void test_turned(void **state)
{
  (void)state;
  static const struct asked asked[] = {
      {"attitude_offset,y_deg=0.5", "attitude_offset,y_deg", false, 0.0, 0.5}};
  double *record, *mean;
  OK(um_core_allocate(context, 2 * nvalue(), sizeof *mean, &mean));
  forecast(periodic, 3, asked, 1, false, &record);
  sample(periodic, 3, asked, 1, mean, mean + nvalue());
  compare(record, mean, mean + nvalue(), 0.06, 2e-4, 60);
  /* what it bends by is of runs alone, not of the looser heat that is predicted by */
  const size_t bus = 1 + NBAND * sizeof(struct um_forecast_band) / sizeof(double);
  double kelvin[3];
  for (size_t i = 0; i < 3; i++) {
    const double at = 0.5 * ((double)i - 1.0);
    run(periodic, 3, asked, 1, &at, mean);
    kelvin[i] = mean[bus];
  }
  double bend = fabs(0.5 * (kelvin[0] + kelvin[2]) - kelvin[1]);
  double of_record = record[2 * nvalue() + TOLD + NBAND];
  print_message("bends by %.5f K, %.5f K by runs\n", of_record, bend);
  assert_close(of_record, bend, 3e-4);
  um_core_free(context, record);
  um_core_free(context, mean);
}

/* Power is not below 0: the bar is the way from none to sigma; thermostats are solved. */
static void test_bound(void **state)
{
  (void)state;
  static const struct asked asked[] = {
      {"heater:bus,power_W=100", "heater:bus,power_W", false, 0.0, 100.0}};
  static const char *const cold[] = {"thermal.start_temperature_K=250"};
  const double none = 0.0;
  double *record, *stands, *moved;
  OK(um_core_allocate(context, 2 * nvalue(), sizeof *stands, &stands));
  moved = stands + nvalue();
  forecast(cold, 1, asked, 1, true, &record);
  run(cold, 1, asked, 1, &none, stands);
  run(cold, 1, asked, 1, &asked[0].sigma, moved);
  const size_t bus = 1 + NBAND * sizeof(struct um_forecast_band) / sizeof(double);
  print_message("%.3f K, %.3f K by runs\n", record[nvalue() + bus], moved[bus] - stands[bus]);
  assert_true(moved[bus] - stands[bus] > 0.5);
  assert_close(record[nvalue() + bus], moved[bus] - stands[bus], 1e-6);
  assert_close(record[2 * nvalue() + NBAND], moved[bus] - stands[bus], 1e-6);
  assert_true(isnan(record[2 * nvalue() + TOLD + NBAND])); /* no other side, no bend */
  um_core_free(context, record);
  um_core_free(context, stands);
}

/* In the pass that is checked the bend of heat is what a run at 1 sigma is off the line, whose
 * slope two runs near by give. */
static void test_bend(void **state)
{
  (void)state;
  static const struct asked asked[] = {
      {"emittance:grey_white=0.15", "emittance:grey_white,factor", false, 1.0, 0.15}};
  const double at[4] = {0.99, 1.0, 1.01, 1.15};
  double *record, kelvin[4], *value;
  const size_t bus = 1 + NBAND * sizeof(struct um_forecast_band) / sizeof(double);
  OK(um_core_allocate(context, nvalue(), sizeof *value, &value));
  forecast(NULL, 0, asked, 1, true, &record);
  for (size_t i = 0; i < 4; i++) {
    run(NULL, 0, asked, 1, &at[i], value);
    kelvin[i] = value[bus];
  }
  double line = (kelvin[2] - kelvin[0]) / 0.02 * 0.15, off = kelvin[3] - kelvin[1] - line;
  double bend = record[2 * nvalue() + TOLD + NBAND];
  print_message("off the line by %.4f K, %.4f K by runs, of %.3f K\n", bend, off, line);
  assert_true(fabs(off) > 0.1);
  assert_close(record[nvalue() + bus] / fabs(line), 1.0, 3e-3);
  assert_close(bend / fabs(off), 1.0, 0.03);
  um_core_free(context, record);
  um_core_free(context, value);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_sample), cmocka_unit_test(test_periodic),
                                     cmocka_unit_test(test_turned), cmocka_unit_test(test_bound),
                                     cmocka_unit_test(test_bend)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
