/* Studies and forecasts by the library beside the command's. */
#include <sys/stat.h>

#include "tests/library/session_test.h"

static const char study[] =
    "schema: 1\n"
    "name: kills\n"
    "scenario: box.yaml\n"
    "parameters:\n"
    "  - {material: grey_white, property: emittance, from: 0.7, to: 0.9}\n"
    "  - {key: parts.bus.shell.areal_heat_capacity_J_m2_K, from: 2000, to: 4000, unit: J/m2/K}\n"
    "design: {kind: latin_hypercube, points: 6, seed: 1}\n"
    "outputs: {bands: [vis, lwir], places: [bus]}\n";

static int enter(void **state)
{
  if (session_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  command_write("study.yaml", study);
  return 0;
}

static struct umbra_points into(const char *folder)
{
  struct umbra_points points = UMBRA_POINTS;
  points.folder = folder;
  points.workers = 2;
  return points;
}

/* Whole, and in shares that a last call gathers: the command's points. */
static void test_study(void **state)
{
  (void)state;
  static const char *const files[] = {"points.csv", "curves.csv", NULL};
  struct umbra_points whole = into("ours"), parts = into("shares");
  size_t missing = 9;
  command_expect(0, "study", "study.yaml", "--workers", "1", "--out", "theirs", NULL);
  ok(umbra_study(umbra, "study.yaml", NULL, &whole, &missing));
  assert_int_equal(missing, 0);
  command_expect_same("theirs", "ours", files);
  assert_true(command_exists("ours/study.nc"));
  assert_false(command_exists("ours.points"));
  parts.nshare = 2;
  for (parts.share = 1; parts.share <= 2; parts.share++)
    ok(umbra_study(umbra, "study.yaml", NULL, &parts, &missing));
  assert_false(command_exists("shares"));
  assert_true(command_exists("shares.points"));
  parts.nshare = 0;
  parts.resume = 1;
  ok(umbra_study(umbra, "study.yaml", NULL, &parts, &missing));
  command_expect_same("theirs", "shares", files);
  assert_false(command_exists("shares.points"));
}

static void test_forecast(void **state)
{
  (void)state;
  static const char *const files[] = {"passes.csv", "curves.csv", NULL};
  const struct umbra_station station = {"Graz", 47.067, 15.493, 495.0};
  struct umbra_forecast_settings settings = UMBRA_FORECAST_SETTINGS;
  const struct umbra_points points = into("ours");
  struct umbra_scenario *scenario;
  size_t missing;
  settings.days = 2.0;
  settings.minimum_elevation_deg = 20.0;
  settings.station = &station;
  settings.nstation = 1;
  settings.from_unix_s = 1473120000.0; /* 2016-09-06T00:00:00Z */
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_forecast(umbra, scenario, &settings, &points, &missing));
  assert_int_equal(missing, 0);
  command_expect(0, "forecast", "box.yaml", "--days", "2", "--minimum-elevation", "20", "--station",
                 "Graz,47.067,15.493,495", "--from", "2016-09-06T00:00:00Z", "--no-plots", "--out",
                 "theirs", NULL);
  command_expect_same("theirs", "ours", files);
  assert_false(command_exists("ours.points"));
  settings.days = 1e6;
  refused(umbra_forecast(umbra, scenario, &settings, &points, &missing), UMBRA_ERR_INPUT, "days");
  umbra_scenario_close(&scenario);
}

static void test_refusals(void **state)
{
  (void)state;
  struct umbra_points points = into(NULL);
  size_t missing;
  refused(umbra_study(umbra, "study.yaml", NULL, &points, &missing), UMBRA_ERR_INPUT, "folder");
  points = into("ours");
  points.share = 3;
  points.nshare = 2;
  refused(umbra_study(umbra, "study.yaml", NULL, &points, &missing), UMBRA_ERR_INPUT, "share 3");
  points = into("mine");
  assert_int_equal(mkdir("mine", 0777), 0);
  command_write("mine/thesis.txt", "mine");
  refused(umbra_study(umbra, "study.yaml", NULL, &points, &missing), UMBRA_ERR_IO, "mine");
  assert_true(command_exists("mine/thesis.txt"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_study, enter, session_leave),
      cmocka_unit_test_setup_teardown(test_forecast, enter, session_leave),
      cmocka_unit_test_setup_teardown(test_refusals, enter, session_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
