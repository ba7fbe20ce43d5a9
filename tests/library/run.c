/* A run by the library: the same bytes as the command's, arrays of the same numbers, errors. */
#include <math.h>
#include <stdlib.h>

#include "tests/library/session_test.h"

static const char *const tables[] = {"lightcurve.csv", "materials.csv", "temperatures.csv",
                                     "heat.csv", NULL};
static const char sphere[] = UMBRA_SOURCE_DIR "/scenarios/sphere";

static void test_sphere_as_the_command(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  ok(umbra_scenario_read(umbra, sphere, NULL, &scenario));
  struct umbra_result *result = session_run(scenario);
  ok(umbra_result_write(umbra, result, "ours", NULL));
  command_expect(0, "run", sphere, "--no-plots", "--out", "theirs", NULL);
  command_expect_same("ours", "theirs", tables);
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static size_t lines_with(const char *path, const char *words)
{
  char *text = command_read(path);
  size_t n = 0;
  for (const char *at = text; (at = strstr(at, words)) != NULL; at++) n++;
  free(text);
  return n;
}

/* What a run logged is its own and its model's, whatever the session did before and after. */
static void test_log_of_a_run(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_result *box = session_run_box();
  ok(umbra_scenario_read(umbra, sphere, NULL, &scenario));
  struct umbra_result *ball = session_run(scenario);
  ok(umbra_result_write(umbra, box, "box", NULL));
  ok(umbra_result_write(umbra, ball, "ball", NULL));
  assert_int_equal(lines_with("box/log.txt", "Earth orientation not given"), 1);
  assert_int_equal(lines_with("box/log.txt", "of 5 observations"), 1);
  assert_int_equal(lines_with("box/log.txt", "of 602 observations"), 0);
  assert_int_equal(lines_with("ball/log.txt", "of 602 observations"), 1);
  assert_int_equal(lines_with("ball/log.txt", "of 5 observations"), 0);
  umbra_result_close(&box);
  umbra_result_close(&ball);
  umbra_scenario_close(&scenario);
}

/* Changes mean what the options of the command do; one text and one file are one scenario. */
static void test_changes_as_the_command(void **state)
{
  (void)state;
  static const char *const name[] = {"factor"};
  static const double value[] = {0.7};
  struct umbra_scenario *scenario;
  struct umbra_effect_change emittance = UMBRA_EFFECT_CHANGE, albedo = UMBRA_EFFECT_CHANGE;
  command_copy_data("box.yaml");
  char *text = command_read("box.yaml");
  ok(umbra_scenario_read(umbra, NULL, text, &scenario));
  free(text);
  ok(umbra_scenario_set_number(umbra, scenario, "parts.bus.shell.areal_heat_capacity_J_m2_K",
                               3000.0 / 7.0));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "40"));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "30"));
  emittance.effect = "emittance";
  emittance.target = "grey_white";
  emittance.parameter = name;
  emittance.value = value;
  emittance.nparameter = 1;
  ok(umbra_scenario_effect(umbra, scenario, &emittance));
  albedo.effect = "albedo";
  albedo.off = 1;
  ok(umbra_scenario_effect(umbra, scenario, &albedo));
  struct umbra_result *result = session_run(scenario);
  ok(umbra_result_write(umbra, result, "ours", NULL));
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "theirs", "--set",
                 "parts.bus.shell.areal_heat_capacity_J_m2_K=428.57142857142856", "--set",
                 "time.step_s=30", "--with", "emittance:grey_white,factor=0.7", "--without",
                 "albedo", NULL);
  command_expect_same("ours", "theirs", tables);
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static double column(const char *table, size_t row, const char *name)
{
  size_t at = 0;
  const char *header = table, *found = strstr(table, name);
  assert_non_null(found);
  for (; header < found; header++) at += *header == ',';
  for (size_t i = 0; i <= row; i++) table = strchr(table, '\n') + 1;
  for (; at > 0; at--) table = strchr(table, ',') + 1;
  return *table == ',' ? (double)NAN : strtod(table, NULL);
}

/* Arrays beside the tables, which state ten digits. */
static void test_arrays(void **state)
{
  (void)state;
  static const struct {
    const char *array, *column;
    size_t offset;
  } pairs[] = {{"irradiance", "vis_irradiance_W_m2", 0},  {"intensity", "lwir_intensity_W_sr", 1},
               {"intensity_error", "vis_stderr_W_sr", 0}, {"magnitude_ab", "vis_mag_ab", 0},
               {"magnitude_vega", "vis_mag_vega", 0},     {"sunlit", "sunlit_fraction", 0}};
  struct umbra_result *result = session_run_box();
  ok(umbra_result_write(umbra, result, "out", NULL));
  char *light = command_read("out/lightcurve.csv"), *heat = command_read("out/temperatures.csv");
  const struct umbra_array *time = umbra_result_array(result, "time_unix_s");
  assert_int_equal(time->dimensions, 1);
  assert_int_equal(time->shape[0], 5);
  assert_close(time->data[1], 1473185280.0, 1e-6); /* 2016-09-06T18:08:00Z */
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
    const struct umbra_array *a = umbra_result_array(result, pairs[i].array);
    for (size_t k = 0; k < 5; k++) {
      double value = a->data[k * (a->dimensions == 2 ? a->shape[1] : 1) + pairs[i].offset];
      double expected = column(light, k, pairs[i].column);
      if (isnan(expected) || isinf(expected)) continue;
      assert_close(value, expected, 1e-8 * fabs(expected));
    }
  }
  const struct umbra_array *range = umbra_result_array(result, "range_m");
  assert_close(range->data[2], 1e3 * column(light, 2, "range_km"), 1.0);
  const struct umbra_array *phase = umbra_result_array(result, "phase_angle_rad");
  assert_close(phase->data[2] * 57.29577951308232, column(light, 2, "phase_angle_deg"), 1e-5);
  const struct umbra_array *hidden = umbra_result_array(result, "hidden");
  assert_true(hidden->data[0] == 1.0 && hidden->data[4] == 0.0);
  const struct umbra_array *place = umbra_result_array(result, "temperature");
  assert_string_equal(place->unit, "K");
  assert_string_equal(place->axis[0], "place");
  assert_close(place->data[3], column(heat, 3, "bus.mean_K"), 1e-4);
  place = umbra_result_array(result, "temperature_lowest");
  assert_close(place->data[3], column(heat, 3, "bus.min_K"), 1e-4);
  place = umbra_result_array(result, "temperature_highest");
  assert_close(place->data[3], column(heat, 3, "bus.max_K"), 1e-4);
  free(light);
  free(heat);
  umbra_result_close(&result);
}

/* By number every array comes once, and parts of the intensity add to it. */
static void test_arrays_by_number(void **state)
{
  (void)state;
  struct umbra_result *result = session_run_box();
  size_t n = 0;
  for (const struct umbra_array *a; (a = umbra_result_array_at(result, n)) != NULL; n++) {
    assert_ptr_equal(umbra_result_array(result, a->name), a);
    assert_true(a->dimensions >= 1 && a->unit != NULL && a->axis[a->dimensions - 1] != NULL);
  }
  assert_true(n >= 17);
  assert_null(umbra_result_array(result, "colour"));
  const struct umbra_array *parts = umbra_result_array(result, "intensity_parts");
  const struct umbra_array *whole = umbra_result_array(result, "intensity");
  size_t each = parts->shape[2] * parts->shape[3];
  for (size_t i = 0; i < whole->shape[0] * whole->shape[1]; i++) {
    double sum = 0.0;
    for (size_t j = 0; j < each; j++) sum += parts->data[i * each + j];
    assert_close(sum, whole->data[i], 1e-12 * fabs(whole->data[i]));
  }
  umbra_result_close(&result);
}

static void test_names(void **state)
{
  (void)state;
  static const char *const expected[] = {"bus", "bus.interior", "grey_white", "vis", NULL, "sun"};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  const char *const *name;
  size_t n;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_model_build(umbra, scenario, &model));
  umbra_scenario_close(&scenario);
  for (int kind = UMBRA_PARTS; kind <= UMBRA_MECHANISMS; kind++) {
    ok(umbra_model_names(umbra, model, (enum umbra_names)kind, &name, &n));
    if (kind == UMBRA_SENSORS) assert_int_equal(n, 0);
    if (kind == UMBRA_PLACES) {
      assert_string_equal(name[0], "bus");
      assert_string_equal(name[n - 1], "material:grey_white");
    } else if (n > 0) {
      assert_string_equal(name[0], expected[kind]);
    }
  }
  refused(umbra_model_names(umbra, model, (enum umbra_names)9, &name, &n), UMBRA_ERR_INPUT,
          "accepted: 0 to 5");
  umbra_model_close(&model);
}

static void test_errors(void **state)
{
  (void)state;
  struct umbra_scenario *scenario;
  struct umbra_settings settings = UMBRA_SETTINGS;
  struct umbra *other;
  settings.size -= 8;
  assert_int_equal(umbra_open(&settings, &other), UMBRA_ERR_INPUT);
  assert_null(other);
  refused(umbra_scenario_read(umbra, "no-such", NULL, &scenario), UMBRA_ERR_IO, "no-such");
  assert_null(scenario);
  refused(umbra_scenario_read(umbra, NULL, NULL, &scenario), UMBRA_ERR_INPUT, "no scenario");
  refused(umbra_scenario_read(umbra, NULL, "schema: 1\nname: x\ncolour: red\n", &scenario),
          UMBRA_ERR_INPUT, "colour");
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_scenario_set(umbra, scenario, "time.step", "3"), UMBRA_ERR_INPUT, "time.step");
  refused(umbra_scenario_set(umbra, scenario, "a=b", "3"), UMBRA_ERR_INPUT, "'='");
  refused(umbra_scenario_set_number(umbra, scenario, "time.step_s", -1.0), UMBRA_ERR_INPUT,
          "time.step_s");
  refused(umbra_scenario_set_number(umbra, scenario, "time.step_s", (double)NAN), UMBRA_ERR_INPUT,
          "finite");
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "120")); /* none of them stayed */
  struct umbra_result *result = session_run(scenario);
  assert_int_equal(umbra_result_array(result, "time_unix_s")->shape[0], 3);
  assert_string_equal(umbra_message(umbra), "");
  command_write("file", "not a folder of Umbra");
  refused(umbra_result_write(umbra, result, "file", NULL), UMBRA_ERR_IO, "file");
  struct umbra_write write = UMBRA_WRITE;
  write.size++;
  refused(umbra_result_write(umbra, result, "out", &write), UMBRA_ERR_INPUT, "size");
  umbra_result_close(&result);
  umbra_scenario_close(&scenario);
}

static void test_errors_of_effects(void **state)
{
  (void)state;
  static const char *const name[] = {"factor"}, *const wrong[] = {"facter"},
                           *const both[] = {"factor", "emittance_factor"};
  static const double value[] = {0.7, 0.7}, large[] = {70.0};
  struct umbra_scenario *scenario;
  struct umbra_model *model;
  struct umbra_effect_change change = UMBRA_EFFECT_CHANGE;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "names no effect");
  change.effect = "emitance";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "emittance");
  change.effect = "emittance";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "needs a target");
  change.target = "paint";
  change.parameter = wrong;
  change.value = value;
  change.nparameter = 1;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "'factor'");
  change.parameter = both;
  change.nparameter = 2;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "are one parameter");
  change.nparameter = 1;
  change.parameter = name;
  change.value = large;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "0.1 to 10");
  change.value = value;
  change.size = 1;
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "size");
  change.size = sizeof change;
  ok(umbra_scenario_effect(umbra, scenario, &change)); /* whether there is a paint is seen here: */
  refused(umbra_model_build(umbra, scenario, &model), UMBRA_ERR_INPUT, "'paint'");
  assert_null(model);
  change = (struct umbra_effect_change)UMBRA_EFFECT_CHANGE;
  change.effect = "albedo";
  change.target = "grey_white";
  refused(umbra_scenario_effect(umbra, scenario, &change), UMBRA_ERR_INPUT, "no target");
  umbra_scenario_close(&scenario);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_sphere_as_the_command, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_log_of_a_run, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_changes_as_the_command, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_arrays, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_arrays_by_number, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_names, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_errors, session_enter, session_leave),
      cmocka_unit_test_setup_teardown(test_errors_of_effects, session_enter, session_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
