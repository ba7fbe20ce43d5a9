/* umbra retrieve: a black sphere of 1 m at 271.5 K that does not cool within the run has an
 * infrared cross-section of pi m2, and what was measured of it in five bands says so within its
 * noise. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/app/command.h"
#include "tests/app/table.h"

static const char *const scenario =
    "schema: 1\n"
    "name: ball\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:04:00Z, step_s: 60}\n"
    "orbit: {fixed: {position_gcrs_km: [4950, 4950, 0]}}\n"
    "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"
    "observer: {station: {latitude_deg: 4, longitude_deg: 47, height_m: 0}}\n"
    "parts:\n"
    "  - {name: ball, sphere: {radius_m: 1}, outside: black, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 1e9}}\n"
    "thermal: {start: isothermal, start_temperature_K: 271.5, orbits_before: 0}\n"
    "bands:\n"
    "  vis: {from_um: 0.4, to_um: 0.8}\n"
    "  a: {from_um: 4, to_um: 5}\n"
    "  b: {from_um: 8, to_um: 9}\n"
    "  c: {from_um: 10, to_um: 12}\n"
    "  d: {from_um: 12, to_um: 14}\n"
    "  e: {from_um: 17, to_um: 24}\n";

/* The polyhedron that stands for the sphere is smaller by a little: 0.3 %. */
static void test_sphere(void **state)
{
  (void)state;
  double temperature = 0.0, area = 0.0;
  command_write("ball.yaml", scenario);
  command_expect(0, "synth", "ball.yaml", "--noise", "0.01,0.0001", "--seed", "3", "-o", "m.csv",
                 NULL);
  command_expect(0, "retrieve", "ball.yaml", "m.csv", "--out", "found", NULL);
  struct table t = table_read("found/retrieved.csv");
  assert_int_equal(t.nrow, 5);
  for (size_t k = 0; k < t.nrow; k++) {
    double sigma = table_number(&t, k, "temperature_sigma_K");
    assert_true(table_number(&t, k, "bands") == 5.0);
    assert_true(sigma > 0.2 && sigma < 1.0);
    assert_true(fabs(table_number(&t, k, "temperature_K") - 271.5) < 4.0 * sigma);
    assert_true(table_number(&t, k, "cold_K") <= table_number(&t, k, "hot_K"));
    temperature += table_number(&t, k, "temperature_K") / 5.0;
    area += table_number(&t, k, "cross_section_m2") / 5.0;
  }
  print_message("%.2f K, %.4f m2\n", temperature, area);
  assert_true(fabs(temperature - 271.5) < 4.0 * 0.41 / sqrt(5.0));
  assert_true(fabs(area / UM_PI - 1.0) < 4.0 * 0.01 / sqrt(5.0) + 3e-3);
  table_release(&t);
}

/* The run says the same of its own light: columns, netCDF, picture. One temperature: no two. */
static void test_columns(void **state)
{
  (void)state;
  command_write("ball.yaml", scenario);
  command_expect(0, "run", "ball.yaml", "--out", "out", NULL);
  struct table t = table_read("out/lightcurve.csv");
  assert_int_equal(t.nrow, 5);
  assert_non_null(strstr(t.header, ",e_mag_ab_1000km,characteristic_temperature_K,"
                                   "characteristic_temperature_error_K,infrared_cross_section_m2,"
                                   "infrared_cross_section_error_m2,grey_body_chi2,"
                                   "cold_temperature_K,cold_cross_section_m2,hot_temperature_K,"
                                   "hot_cross_section_m2"));
  for (size_t k = 0; k < t.nrow; k++) {
    assert_true(fabs(table_number(&t, k, "characteristic_temperature_K") - 271.5) < 1e-3);
    assert_true(fabs(table_number(&t, k, "infrared_cross_section_m2") / UM_PI - 1.0) < 3e-3);
    assert_true(table_number(&t, k, "characteristic_temperature_error_K") >= 0.0);
    assert_true(table_number(&t, k, "grey_body_chi2") < 1e-6);
    assert_string_equal(table_text(&t, k, "hot_temperature_K"), "");
  }
  table_release(&t);
  assert_true(command_exists("out/grey_body.png"));
  command_expect(0, "synth", "ball.yaml", "--noise", "0.01,0.0001", "--seed", "3", "--grey-body",
                 "-o", "m.csv", NULL);
  command_expect(0, "compare", "ball.yaml", "m.csv", "--out", "compared", NULL);
  assert_true(command_exists("compared/characteristic_temperature_thermal.png"));
}

static void test_refused(void **state)
{
  (void)state;
  static const char *const rows = "time_utc,quantity,of,value,sigma\n"
                                  "2020-03-20T12:00:00Z,band_irradiance,a,1e-12,1e-14\n"
                                  "2020-03-20T12:00:00Z,band_irradiance,b,1e-11,1e-13\n";
  char text[512];
  command_write("ball.yaml", scenario);
  command_write("m.csv", rows);
  struct command c = command_run("retrieve", "ball.yaml", "m.csv", "--out", "found", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(
      strstr(c.err, "m.csv: at no time light in three bands of 3 to 40 um; accepted: "));
  command_release(&c);
  snprintf(text, sizeof text, "%s2020-03-20T12:00:00Z,band_irradiance,c,1e-11,\n", rows);
  command_write("m.csv", text);
  c = command_run("retrieve", "ball.yaml", "m.csv", "--out", "found", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "m.csv:4: column 'sigma': is empty; accepted: a number above 0"));
  assert_false(command_exists("found"));
  command_release(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_sphere, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_columns, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
