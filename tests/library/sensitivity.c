/* The matrix of sensitivities by the library beside the command's, and what it says of other values
 * beside a run of them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/library/session_test.h"

static struct umbra_scenario *scenario;

static int enter(void **state)
{
  if (session_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "30"));
  return 0;
}

static int leave(void **state)
{
  umbra_scenario_close(&scenario);
  return session_leave(state);
}

static const double *row_of(const struct umbra_array *a, size_t row)
{
  return a->data + row * a->shape[1] * a->shape[2];
}

static size_t column_of(const struct umbra_sensitivity *s, const char *name)
{
  for (size_t i = 0; i < s->nderivative; i++)
    if (strcmp(s->derivative[i].name, name) == 0) return i;
  fail_msg("no column %s", name);
  return 0;
}

/* A factor on a band moves that band by itself, and no temperature. */
static void test_matrix(void **state)
{
  (void)state;
  static const char *const only[] = {"zero_point", "emittance", "heat_capacity", "diffuse_level",
                                     "attitude_offset"};
  static const char *const files[] = {"sensitivity.csv", "parameters.csv", NULL};
  struct umbra_sensitivity_settings settings = UMBRA_SENSITIVITY_SETTINGS;
  struct umbra_write write = UMBRA_WRITE;
  struct umbra_result *result;
  settings.only = only;
  settings.nonly = 5;
  ok(umbra_sensitivity(umbra, scenario, NULL, &settings, &result));
  const struct umbra_sensitivity *s = umbra_result_sensitivity(result);
  const struct umbra_array *light = umbra_result_array(result, "light"),
                           *d_light = umbra_result_array(result, "d_light"),
                           *d_heat = umbra_result_array(result, "d_temperature");
  assert_non_null(s);
  assert_int_equal(d_light->dimensions, 3);
  assert_int_equal(d_light->shape[0], s->nderivative);
  assert_int_equal(d_light->shape[1], s->nband);
  assert_int_equal(d_heat->shape[1], s->nplace);
  assert_int_equal(umbra_result_array(result, "time_unix_s")->shape[0], light->shape[1]);
  size_t zero = column_of(s, "zero_point:vis.factor"), n = light->shape[1], seen = 0;
  assert_string_equal(s->band[0], "vis");
  for (size_t k = 0; k < n; k++) {
    if (isnan(light->data[k])) continue;
    assert_close(row_of(d_light, zero)[k], light->data[k], 1e-9 * fabs(light->data[k]));
    assert_true(row_of(d_light, zero)[n + k] == 0.0 && row_of(d_heat, zero)[k] == 0.0);
    seen++;
  }
  assert_true(seen > 5);
  assert_string_equal(s->derivative[zero].method, "behind");
  write.command = "umbra sensitivity box.yaml";
  ok(umbra_result_write(umbra, result, "ours", &write));
  command_expect(0, "sensitivity", "box.yaml", "--set", "time.step_s=30", "--only", "zero_point",
                 "--only", "emittance", "--only", "heat_capacity", "--only", "diffuse_level",
                 "--only", "attitude_offset", "--no-plots", "--out", "theirs", NULL);
  command_expect_same("ours", "theirs", files);
  umbra_result_close(&result);
}

static void test_what_if(void **state)
{
  (void)state;
  static const char *const only[] = {"zero_point:vis", "emittance:grey_white"};
  struct umbra_sensitivity_settings settings = UMBRA_SENSITIVITY_SETTINGS;
  struct umbra_result *matrix, *linear;
  settings.only = only;
  settings.nonly = 2;
  ok(umbra_sensitivity(umbra, scenario, NULL, &settings, &matrix));
  const struct umbra_sensitivity *s = umbra_result_sensitivity(matrix);
  const struct umbra_array *light = umbra_result_array(matrix, "light"),
                           *heat = umbra_result_array(matrix, "temperature"),
                           *d_heat = umbra_result_array(matrix, "d_temperature");
  const size_t column[] = {column_of(s, "zero_point:vis.factor"),
                           column_of(s, "emittance:grey_white.factor")};
  double value[] = {1.5, 0.99};
  size_t n = light->shape[1];
  ok(umbra_what_if(umbra, matrix, column, value, 2, &linear));
  const struct umbra_array *then = umbra_result_array(linear, "light"),
                           *warm = umbra_result_array(linear, "temperature");
  for (size_t k = 0; k < n; k++) {
    if (!isnan(light->data[k]))
      assert_close(then->data[k], 1.5 * light->data[k], 1e-3 * fabs(light->data[k]));
    double expected = heat->data[k] - 0.01 * row_of(d_heat, column[1])[k];
    assert_close(warm->data[k], expected, 1e-9);
    assert_true(warm->data[k] > heat->data[k]);
  }
  const struct umbra_citation *citation;
  assert_int_equal(umbra_cite(umbra, linear, &citation), UMBRA_ERR_INPUT);
  ok(umbra_cite(umbra, matrix, &citation));
  umbra_result_close(&linear);
  value[1] = 1e9;
  assert_int_equal(umbra_what_if(umbra, matrix, column, value, 2, &linear), UMBRA_ERR_INPUT);
  umbra_result_close(&matrix);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_matrix, enter, leave),
      cmocka_unit_test_setup_teardown(test_what_if, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
