/* Model values of measured rows: the right number of the right instant, and what is refused. */
#include "tests/evidence/model_test.h"

#include "evidence/comparison/comparison.h"
#include "evidence/comparison/predict.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "orbit/time.h"

/* Every quantity once, out of the order of the channels, tracks interleaved; flagged rows may be
 * anything. Values are those of a run at the same times (same bytes: the same geometry
 * tables), of which E = I / R^2 without exposure, and the places are the ones that short
 * and full names mean. */
static void test_values(void **state)
{
  (void)state;
  struct um_model *model = model_of(NULL);
  put("m.csv",
      "time_utc,quantity,of,value,sigma,track,flag\n" /* line 1 */
      DAY "12:00Z,temperature,interior,280,1,a,0\n" DAY "12:00Z,band_irradiance,lwir,1,1,a,0\n" DAY
      "12:07.5Z,radiant_intensity,vis,1,1,a,0\n" DAY "12:07.5Z,magnitude_ab,vis,5,1,a,0\n" DAY
      "12:07.5Z,count_rate,ufo,5,1,a,1\n" DAY "11:00Z,temperature,panel.back,280,1,b,0\n" DAY
      "12:00Z,temperature,bus.interior,280,1,b,0\n" DAY "12:07.5Z,temperature,+x,280,1,b,0\n" DAY
      "12:07.5Z,temperature,material:grey_panel,280,1,b,0\n" DAY
      "23:59Z,band_irradiance,lwir,1,1,b,2\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  const double *value = p.comparison->model;
  assert_int_equal(p.plan->ntime, 3);
  static const size_t expected[] = {1, 1, 2, 2, UM_COMPARE_NOWHERE, 0, 1, 2, 2, UM_COMPARE_NOWHERE};
  for (size_t i = 0; i < 10; i++) assert_true(p.plan->observation[i] == expected[i]);
  const struct um_model_result *r = p.result;
  double range = p.tables->look[1].range;
  assert_true(fabs(value[1] * range * range / um_model_result_intensity(r, 1, 1, -1) - 1.0) <
              1e-12); /* sums of five mechanisms in another order */
  assert_true(value[2] == um_model_result_intensity(r, 2, 0, -1));
  assert_true(value[3] == r->magnitude_ab[2 * r->nband]);
  assert_true(isnan(value[4]) && isnan(value[9]));
  static const struct {
    size_t row, observation;
    const char *place;
  } places[] = {{0, 1, "bus.interior"},
                {5, 0, "panel.back"},
                {6, 1, "bus.interior"},
                {7, 2, "bus.+x"},
                {8, 2, "material:grey_panel"}};
  for (size_t i = 0; i < 5; i++) {
    size_t at = 0;
    while (strcmp(r->place[at].name, places[i].place) != 0) at++;
    assert_true(value[places[i].row] == r->place[at].mean[places[i].observation]);
  }
  assert_true(value[0] == value[6]);
  /* rows of two tracks are in order of time */
  const struct um_compare_channel_comparison *c = channel_named(p.comparison, "lwir");
  assert_int_equal(c->count, 1);
  assert_int_equal(c->left_out, 1);
  pair_end(&p);
  um_model_destroy(context, &model);
}

static void refused(const struct um_model *model, const char *text, const char *message)
{
  struct um_compare_measurements *m;
  struct um_compare_plan *plan;
  put("m.csv", text);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_refused(um_compare_plan_create(context, model, m, &plan), UM_ERR_INPUT, message);
  assert_null(plan);
  um_compare_measurements_destroy(context, &m);
}

/* Rows of one time share an exposure, an empty one joins it; alone it is the scenario's, here 0.
 * Overlaps are refused. */
static void test_exposures(void **state)
{
  (void)state;
  struct um_model *model = model_of(NULL);
  const char *head = "time_utc,quantity,of,value,sigma,exposure_s\n";
  char text[512];
  snprintf(text, sizeof text,
           "%s" DAY "12:00Z,band_irradiance,lwir,1,1,4\n" DAY
           "12:00Z,temperature,interior,280,1,\n" DAY "12:10Z,temperature,interior,280,1,\n",
           head);
  put("m.csv", text);
  struct pair p = pair_of(model, "m.csv", 0.0);
  assert_int_equal(p.plan->ntime, 2);
  assert_true(p.plan->exposure[0] == 4.0 && p.plan->exposure[1] == 0.0);
  assert_int_equal(p.plan->observation[0], 0);
  assert_int_equal(p.plan->observation[1], 0);
  assert_int_equal(p.plan->observation[2], 1);
  pair_end(&p);
  snprintf(text, sizeof text,
           "%s" DAY "12:00Z,band_irradiance,lwir,1,1,4\n" DAY "12:00Z,band_irradiance,vis,1,1,0\n",
           head);
  refused(model, text,
          "m.csv:3: column 'exposure_s': 0 s, another row of this time has 4 s; accepted: one "
          "exposure at a time");
  snprintf(text, sizeof text,
           "%s" DAY "12:00Z,band_irradiance,lwir,1,1,4\n" DAY
           "12:02.9Z,band_irradiance,vis,1,1,2\n",
           head);
  refused(model, text,
          "m.csv:3: column 'exposure_s': the exposure of 2 s begins before the one before it ends; "
          "accepted: exposures that do not overlap");
  um_model_destroy(context, &model);
}

#define PLACES                                                                                     \
  "bus, bus.+x, bus.-x, bus.+y, bus.-y, bus.+z, bus.-z, bus.interior, panel, panel.front, "        \
  "panel.back, panel.plate, panel.plate.back, material:NAME"

static void test_refusals(void **state)
{
  (void)state;
  struct um_model *model = model_of(NULL);
  refused(model, HEAD DAY "12:00Z,band_irradiance,lwr,1,1\n",
          "m.csv:2: column 'of': the scenario has no band 'lwr'; did you mean 'lwir'?; accepted: "
          "vis, lwir");
  refused(model, HEAD DAY "12:00Z,magnitude_ab,V,1,1\n",
          "m.csv:2: column 'of': the scenario has no band 'V'; accepted: vis, lwir");
  refused(model,
          "# note\n" HEAD DAY "12:00Z,temperature,+x,280,1\n" DAY
          "12:00Z,temperature,radiator,280,1\n",
          "m.csv:4: column 'of': the scenario has no place 'radiator'; accepted: " PLACES);
  refused(model, HEAD DAY "12:00Z,temperature,frnt,280,1\n",
          "m.csv:2: column 'of': the scenario has no place 'frnt'; did you mean 'front'?; "
          "accepted: " PLACES);
  refused(model, HEAD DAY "12:00Z,magnitude_vega,Clear,1,1\n",
          "m.csv:2: column 'of': the scenario has no band 'Clear'; accepted: vis, lwir");
  refused(
      model, HEAD DAY "12:00Z,count_rate,ufo,1,1\n",
      "m.csv:2: column 'of': 'ufo' is not a sensor: the scenario has none; accepted: a scenario "
      "with sensors");
  refused(model, HEAD DAY "12:00Z,temperature,+x,280,1\n" DAY "20:05Z,temperature,+x,280,1\n",
          "m.csv:3: column 'time_utc': 2016-09-06T18:20:05.000Z is outside the scenario; accepted: "
          "2016-09-06T18:08:00.000Z to 2016-09-06T18:20:00.000Z (time.start_utc, time.stop_utc)");
  refused(model, "time_utc,quantity,of,value,sigma,flag\n" DAY "12:00Z,temperature,+x,280,1,1\n",
          "m.csv: every row is flagged; accepted: at least one row with flag 0");
  um_model_destroy(context, &model);
}

/* Which of two sides; no observer; an orbit that ends. */
static void test_other_scenarios(void **state)
{
  (void)state;
  char text[8192];
  struct um_model *model;
  /* two plates */
  const char *tail = strstr(scenario_text, "thermal:");
  snprintf(text, sizeof text,
           "%.*s  - {name: wing, plate: {size_m: [1, 1]}, pose: {position_m: [0, 6, 0]}, front: "
           "grey_panel, back: grey_metal, lumped: true, shell: {areal_heat_capacity_J_m2_K: 2000, "
           "through_conductance_W_m2_K: 50}}\n%s",
           (int)(tail - scenario_text), scenario_text, tail);
  put(SCENARIO, text);
  model = model_of(NULL);
  refused(model, HEAD DAY "12:00Z,temperature,front,280,1\n",
          "m.csv:2: column 'of': 'front' stands for more than one place; accepted: panel.front, "
          "wing.front");
  um_model_destroy(context, &model);
  /* nobody looks */
  const char *observer = strstr(scenario_text, "observer:"),
             *parts = strstr(scenario_text, "parts:");
  snprintf(text, sizeof text, "%.*s%s", (int)(observer - scenario_text), scenario_text, parts);
  put(SCENARIO, text);
  model = model_of(NULL);
  refused(model, HEAD DAY "12:00Z,band_irradiance,vis,1,1\n",
          "m.csv:2: column 'quantity': band_irradiance wants an observer, which the scenario has "
          "not; accepted: temperature");
  put("m.csv", HEAD DAY "12:00Z,temperature,interior,280,1\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  assert_true(p.comparison->model[0] > 200.0 && p.comparison->model[0] < 400.0);
  assert_int_equal(p.comparison->motion[0], UM_SEGMENT_COUNT);
  pair_end(&p);
  um_model_destroy(context, &model);
  put(SCENARIO, scenario_text);
}

/* A table that ends within the scenario: the row that it does not reach is named. */
static void test_orbit_ends(void **state)
{
  (void)state;
  char text[8192];
  const char *tle = strstr(scenario_text, "  tle:"), *attitude = strstr(scenario_text, "attitude:");
  put("orbit.csv", "time_utc,x_km,y_km,z_km\n" DAY "07:00Z,7150,0,0\n" DAY
                   "10:00Z,7024,1337,0\n" DAY "13:00Z,6649,2629,0\n" DAY "16:00Z,6042,3823,0\n");
  snprintf(text, sizeof text, "%.*s  table: orbit.csv\n%s", (int)(tle - scenario_text),
           scenario_text, attitude);
  put(SCENARIO, text);
  struct um_model *model = model_of(NULL);
  refused(model, HEAD DAY "12:00Z,temperature,+x,280,1\n" DAY "16:00.5Z,temperature,+x,280,1\n",
          "m.csv:3: orbit.csv: a position is wanted at 2016-09-06T18:16:00.500Z; the table covers "
          "2016-09-06T18:07:00.000Z to 2016-09-06T18:16:00.000Z");
  um_model_destroy(context, &model);
  put(SCENARIO, scenario_text);
}

/* A radiant intensity is concluded from what was measured: a calibration that is off by half is in
 * it, an atmosphere is not. */
static void test_measured_intensity(void **state)
{
  (void)state;
  static const char *const with[] = {"zero_point:lwir,factor=0.5", "extinction,k_mag=0.4"};
  double value[2][2];
  put("m.csv",
      HEAD DAY "14:00Z,radiant_intensity,vis,1,1\n" DAY "14:00Z,radiant_intensity,lwir,1,1\n");
  for (int i = 0; i < 2; i++) {
    const struct um_model_options options = {.with = with, .nwith = i == 0 ? 0 : 2};
    struct um_model *model = model_of(&options);
    struct pair p = pair_of(model, "m.csv", 0.0);
    memcpy(value[i], p.comparison->model, sizeof value[i]);
    pair_end(&p);
    um_model_destroy(context, &model);
  }
  assert_true(value[0][0] > 0.0 && value[1][0] == value[0][0]);
  assert_true(value[0][1] > 0.0 && fabs(value[1][1] / value[0][1] - 0.5) <= 1e-14);
}

/* The pass rises at 18:07:50: a magnitude before has no meaning, an intensity has. */
static void test_horizon(void **state)
{
  (void)state;
  const char *earlier = "time.start_utc=2016-09-06T18:07:00Z";
  struct um_model *model =
      model_of(&(struct um_model_options){.overrides = &earlier, .noverride = 1});
  put("m.csv", HEAD DAY "07:30Z,radiant_intensity,lwir,1,1\n");
  struct pair p = pair_of(model, "m.csv", 0.0);
  assert_true(p.comparison->model[0] > 0.0);
  um_compare_destroy(context, &p.comparison);
  um_compare_measurements_destroy(context, &p.measurements);
  um_compare_plan_destroy(context, &p.plan);
  static const char *const rows[] = {HEAD DAY "07:30Z,magnitude_ab,lwir,1,1\n",
                                     HEAD DAY "07:30Z,band_irradiance,lwir,1,1\n"};
  for (size_t i = 0; i < 2; i++) {
    double value;
    put("m.csv", rows[i]);
    assert_ok(um_compare_measurements_read(context, "m.csv", &p.measurements));
    assert_ok(um_compare_plan_create(context, model, p.measurements, &p.plan));
    um_core_message_clear(context);
    assert_int_equal(um_compare_predict(context, p.plan, p.tables, p.result, &value), UM_ERR_INPUT);
    char message[256];
    snprintf(message, sizeof message,
             "m.csv:2: column 'time_utc': the satellite is below the horizon (elevation %.2f deg); "
             "accepted: rows above it, or a flag that leaves the row out",
             p.tables->look[0].elevation / UM_DEG);
    assert_string_equal(um_core_message(context), message);
    um_compare_plan_destroy(context, &p.plan);
    um_compare_measurements_destroy(context, &p.measurements);
  }
  pair_end(&p);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_values),
                                     cmocka_unit_test(test_exposures),
                                     cmocka_unit_test(test_refusals),
                                     cmocka_unit_test(test_other_scenarios),
                                     cmocka_unit_test(test_orbit_ends),
                                     cmocka_unit_test(test_horizon),
                                     cmocka_unit_test(test_measured_intensity)};
  return cmocka_run_group_tests(tests, model_set_up, model_tear_down);
}
