/* Passes of a forecast by themselves: their times and shadow against the geometry of each instant,
 * their numbers against the light and the temperatures of a run of the same instants. */
#include "forecast/forecast.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "forecast/forecast_impl.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/forecast/box_test.h"

/* A box that a wing shades, so that rays tell its light with an error. */
static const char scenario[] = BOX("2016-09-06T18:07:00Z", "2016-09-06T18:11:00Z");

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

/* Is the centre of the Sun above the limb at a time of the satellite? */
static bool sunlit(const struct um_model *model, double t)
{
  struct um_environment_sample s;
  OK(um_model_sample_at(context, model, t, &s));
  return um_environment_limb_angle(&model->environment, s.r, s.sun, s.sun_distance, s.pole) > 0.0;
}

/* Of half a day of two stations, passes begin and end in the Sun and in the shadow, and cross its
 * edge where they say. */
static void test_shadow(void **state)
{
  (void)state;
  const struct um_forecast_station station[2] = {{"Graz", 47.067 * UM_DEG, 15.493 * UM_DEG, 495.0},
                                                 {"South", -60.0 * UM_DEG, 40.0 * UM_DEG, 0.0}};
  struct um_model_options options = {0};
  struct um_forecast_ask ask = {.path = path,
                                .options = &options,
                                .from = NAN,
                                .days = 0.5,
                                .minimum_elevation = 5.0 * UM_DEG,
                                .station = station,
                                .nstation = 2};
  struct um_batch_task task = {0};
  struct um_forecast *f;
  struct um_model *model;
  size_t rises[2] = {0, 0}, sets[2] = {0, 0}, edges = 0;
  OK(um_model_create_orbit(context, path, &options, &model));
  OK(um_forecast_create(context, &ask, &task, &f));
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *p = &f->pass[i];
    bool at_rise = sunlit(model, p->pass.rise), at_set = sunlit(model, p->pass.set);
    assert_true(i == 0 || p->pass.rise >= f->pass[i - 1].pass.rise);
    assert_int_equal(p->sunlit_at_rise, at_rise);
    assert_int_equal(p->sunlit_at_set, at_set);
    rises[at_rise]++;
    sets[at_set]++;
    assert_int_equal(isfinite(p->entry), at_rise && !at_set); /* shadows last longer than passes */
    assert_int_equal(isfinite(p->exit), !at_rise && at_set);
    const double edge[2] = {p->entry, p->exit};
    for (int k = 0; k < 2; k++) {
      if (isnan(edge[k])) continue;
      edges++;
      assert_true(edge[k] >= p->pass.rise && edge[k] <= p->pass.set);
      assert_int_equal(sunlit(model, edge[k] - 0.01), k == 0);
      assert_int_equal(sunlit(model, edge[k] + 0.01), k == 1);
    }
    /* whole seconds inside the pass */
    assert_true(p->start == floor(p->start) && p->stop == floor(p->stop));
    assert_true(p->start >= p->pass.rise && p->start < p->pass.rise + 1.0);
    assert_true(p->stop <= p->pass.set && p->stop > p->pass.set - 1.0);
    assert_true(p->pass.culmination >= f->from && p->pass.culmination < f->from + 43200.0);
  }
  print_message("%zu passes: %zu rise in the Sun, %zu set there, %zu cross the edge\n", f->npass,
                rises[1], sets[1], edges);
  assert_true(rises[0] > 0 && rises[1] > 0 && sets[0] > 0 && sets[1] > 0 && edges > 0);
  um_forecast_destroy(context, &f);
  um_model_destroy(context, &model);
}

/* What is brightest, largest and nearest of a run's instants; the error is how far the magnitude
 * moves by a small part of the flux's. */
static void check_band(const struct um_model_tables *p, const struct um_model_result *r, size_t b,
                       double culmination, const struct um_forecast_band *band)
{
  size_t best = 0, largest = 0, middle = 0;
  double intensity = 0.0;
  for (size_t k = 1; k < r->nobs; k++) {
    assert_false(p->hidden[k]);
    if (r->magnitude_ab[k * r->nband + b] < r->magnitude_ab[best * r->nband + b]) best = k;
    if (r->irradiance[k * r->nband + b] > r->irradiance[largest * r->nband + b]) largest = k;
    if (fabs(p->t_obs[k] - culmination) < fabs(p->t_obs[middle] - culmination)) middle = k;
  }
  for (size_t k = 0; k < r->nobs; k++)
    intensity = fmax(intensity, um_model_result_intensity(r, k, b, -1));
  best = best * r->nband + b;
  double m = r->magnitude_ab[best], flux = pow(10.0, -0.4 * m), error = r->magnitude_error[best];
  print_message("band %zu: %.4f mag +- %.2g, of %zu instants\n", b, m, band->error, r->nobs);
  assert_close(band->brightest, m, 0.0);
  assert_close(band->brightest_at, p->t_obs[best / r->nband], 0.0);
  assert_close(band->culmination, r->magnitude_ab[middle * r->nband + b], 0.0);
  assert_close(band->irradiance_culmination, r->irradiance[middle * r->nband + b], 0.0);
  assert_close(band->largest, r->irradiance[largest * r->nband + b], 0.0);
  assert_close(band->largest_at, p->t_obs[largest], 0.0);
  assert_close(band->intensity, intensity, 0.0);
  assert_true(error > 1e-5 * flux && error < 0.1 * flux);
  assert_close(band->error / (1e4 * 2.5 * log10(1.0 + 1e-4 * error / flux)), 1.0, 1e-5);
}

/* The first pass over Graz, in and out of the umbra. */
static void test_run(void **state)
{
  (void)state;
  const char *const when[] = {"time.start_utc=2016-09-06T18:09:00Z",
                              "time.stop_utc=2016-09-06T18:13:00Z"};
  const struct um_model_options options = {.overrides = when, .noverride = 2};
  static const size_t place[] = {0, 1};
  struct um_forecast_work work = {.nband = 2, .nplace = 2, .place = place};
  const struct um_variant_settings settings = {.base = {1.0, 0.01}};
  struct um_model *model, *stands;
  struct um_model_tables *p;
  struct um_model_result *r;
  OK(um_model_create(context, path, NULL, &stands));
  OK(um_variant_evaluator_create(context, stands, &settings, &work.evaluator));
  work.model = stands;
  OK(um_model_create(context, path, &options, &model));
  OK(um_model_precompute(context, model, &p));
  OK(um_model_run(context, model, p, &r));
  size_t nvalue = um_forecast_values(2, 2), last = r->nobs - 1;
  double culmination = p->t_obs[last] - 57.0, *value, *curve;
  const double at[UM_FORECAST_COORDINATES] = {0.0, p->t_obs[0], p->t_obs[last], culmination};
  OK(um_core_allocate(context, nvalue, sizeof *value, &value));
  OK(um_forecast_compute(context, &work, at, value));
  assert_close(value[0], model->orbit_delay, 0.0);
  for (size_t b = 0; b < 2; b++) {
    struct um_forecast_band band;
    memcpy(&band, value + 1 + b * sizeof band / sizeof *value, sizeof band);
    check_band(p, r, b, culmination, &band);
  }
  for (size_t i = 0; i < 2; i++) {
    double sum = 0.0, low = INFINITY, high = 0.0;
    const double *of = value + 1 + 2 * 8 + 3 * i;
    for (size_t k = 0; k < r->nobs; k++) {
      double kelvin = r->place[i].mean[k];
      sum += kelvin;
      low = kelvin < low ? kelvin : low;
      high = kelvin > high ? kelvin : high;
    }
    assert_close(of[0], sum / (double)r->nobs, 1e-9);
    assert_close(of[1], low, 0.0);
    assert_close(of[2], high, 0.0);
    assert_true(high > low);
  }
  curve = value + nvalue - 5 * UM_FORECAST_CURVE;
  assert_close(curve[0], p->t_obs[0], 0.0);
  assert_close(curve[UM_FORECAST_CURVE - 1], p->t_obs[last], 0.0);
  for (size_t c = 0; c < 4; c++) { /* magnitude and irradiance of each band */
    const double *of = c % 2 == 0 ? r->magnitude_ab : r->irradiance;
    const double *here = curve + (1 + c) * UM_FORECAST_CURVE;
    assert_close(here[0], of[c / 2], 0.0);
    assert_close(here[UM_FORECAST_CURVE - 1], of[last * 2 + c / 2], 0.0);
  }
  um_core_free(context, value);
  um_model_result_destroy(context, &r);
  um_model_tables_destroy(context, &p);
  um_model_destroy(context, &model);
  um_variant_evaluator_destroy(context, &work.evaluator);
  um_model_destroy(context, &stands);
}

/* From a periodic start heat of a pass begins where that of the scenario repeats, solved more
 * loosely: a pass a day later is the same as a run of its own to 0.1 K and 1e-3 of the heat that is
 * seen, which a forecast is asked for. */
static void test_periodic(void **state)
{
  (void)state;
  const char *const keys[] = {"thermal.start=periodic", "thermal.orbits_before=1",
                              "time.start_utc=2016-09-07T18:34:00Z",
                              "time.stop_utc=2016-09-07T18:38:00Z"};
  const struct um_model_options options = {.overrides = keys, .noverride = 2};
  const struct um_model_options later = {.overrides = keys, .noverride = 4};
  static const size_t place[] = {0, 1};
  struct um_forecast_work work = {.nband = 2, .nplace = 2, .place = place};
  struct um_model *own, *stands;
  struct um_model_tables *p;
  struct um_model_result *r;
  OK(um_model_create(context, path, &options, &stands));
  const struct um_model_instants instant = {.time = &stands->scenario->time->start, .count = 1};
  const struct um_variant_settings settings = {.instants = &instant, .base = {1.0, 0.01}};
  OK(um_variant_evaluator_create(context, stands, &settings, &work.evaluator));
  work.model = stands;
  OK(um_model_create(context, path, &later, &own));
  OK(um_model_precompute(context, own, &p));
  OK(um_model_run(context, own, p, &r));
  size_t nvalue = um_forecast_values(2, 2), last = r->nobs - 1;
  const double at[UM_FORECAST_COORDINATES] = {0.0, p->t_obs[0], p->t_obs[last], p->t_obs[0]};
  double *value;
  OK(um_core_allocate(context, nvalue, sizeof *value, &value));
  OK(um_forecast_compute(context, &work, at, value));
  for (size_t i = 0; i < 2; i++) {
    double mean = 0.0;
    for (size_t k = 0; k < r->nobs; k++) mean += r->place[i].mean[k] / (double)r->nobs;
    print_message("place %zu: %.4f K, %.2g K from a run of its own\n", i, mean,
                  value[1 + 2 * 8 + 3 * i] - mean);
    assert_true(value[1 + 2 * 8 + 3 * i] != mean); /* it is another solution */
    assert_close(value[1 + 2 * 8 + 3 * i], mean, 0.1);
  }
  struct um_forecast_band lwir;
  memcpy(&lwir, value + 1 + sizeof lwir / sizeof *value, sizeof lwir);
  double most = 0.0;
  for (size_t k = 0; k < r->nobs; k++) most = fmax(most, um_model_result_intensity(r, k, 1, -1));
  print_message("LWIR: %.4g W/sr, %.2g of it from a run of its own\n", most,
                lwir.intensity / most - 1.0);
  assert_close(lwir.intensity / most, 1.0, 1e-3);
  um_core_free(context, value);
  um_model_result_destroy(context, &r);
  um_model_tables_destroy(context, &p);
  um_model_destroy(context, &own);
  um_variant_evaluator_destroy(context, &work.evaluator);
  um_model_destroy(context, &stands);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_shadow), cmocka_unit_test(test_run),
                                     cmocka_unit_test(test_periodic)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
