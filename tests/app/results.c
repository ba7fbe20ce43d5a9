/* The tables and texts of a run: what stands in them, and that they add up. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/box_run.h"

/* DESIGN.md, "Outputs". */
#define BAND_COLUMNS(b)                                                                            \
  "," b "_intensity_W_sr," b "_sun_W_sr," b "_earth_W_sr," b "_emitted_W_sr," b                    \
  "_interreflected_W_sr," b "_other_W_sr," b "_stderr_W_sr," b "_irradiance_W_m2," b "_mag_ab," b  \
  "_mag_vega," b "_mag_ab_1000km"
#define LIGHTCURVE_HEADER                                                                          \
  "time_utc,azimuth_deg,elevation_deg,range_km,airmass,phase_angle_deg,sunlit_fraction,"           \
  "sun_elevation_deg" BAND_COLUMNS("vis") BAND_COLUMNS("lwir")
#define MATERIALS_HEADER "time_utc,band,material,sun,earth,emitted,interreflected,other"
#define HEAT_HEADER      "time_utc,node,solar,albedo,planet,internal,conducted,radiated,exchanged,stored"
#define PLACE(name)      "," name ".mean_K," name ".min_K," name ".max_K"

/* The Sun is down behind the Earth until 18:10:04.9 (umbra forecast --times); the satellite rises
 * at 18:07:50. Without the Earth's air the Sun term is exactly zero until then and the heat is not;
 * 5 s before, air bends a few percent of sunlight in, and 55 s after hides less than 1e-5 of it. */
static void test_lightcurve(void **state)
{
  (void)state;
  struct table t = table_read("out/lightcurve.csv");
  assert_string_equal(t.header, LIGHTCURVE_HEADER);
  assert_int_equal(t.nrow, 5);
  for (size_t k = 0; k < t.nrow; k++) {
    char time[32];
    snprintf(time, sizeof time, "2016-09-06T18:%02zu:00.000Z", 7 + k);
    assert_string_equal(table_text(&t, k, "time_utc"), time);
    bool up = table_number(&t, k, "elevation_deg") > 0.0, lit = k >= 3;
    assert_int_equal(up, k >= 1);
    assert_int_equal(table_text(&t, k, "airmass")[0] != '\0', up);
    double sunlit = table_number(&t, k, "sunlit_fraction");
    if (!lit) assert_true(sunlit == 0.0);
    if (k == 3) assert_true(sunlit > 0.01 && sunlit < 0.1);
    if (k == 4) assert_close(sunlit, 1.0, 1e-5);
    double range = 1e3 * table_number(&t, k, "range_km");
    for (int b = 0; b < 2; b++) {
      double intensity = band_number(&t, k, bands[b], "intensity_W_sr");
      assert_true(intensity > 0.0);
      double sun = band_number(&t, k, bands[b], "sun_W_sr"); /* air scatters some into the shadow */
      assert_true(lit ? sun > 0.0 : sun < 1e-3 * band_number(&t, 4, bands[b], "sun_W_sr"));
      assert_true(band_number(&t, k, bands[b], "stderr_W_sr") >= 0.0);
      if (!up) {
        assert_string_equal(band_text(&t, k, bands[b], "irradiance_W_m2"), "");
        assert_string_equal(band_text(&t, k, bands[b], "mag_ab"), "");
        continue;
      }
      (void)band_number(&t, k, bands[b], "mag_ab");
      /* E = I / R^2 without an atmosphere */
      double e = band_number(&t, k, bands[b], "irradiance_W_m2");
      assert_close(e * range * range / intensity, 1.0, PRINTED);
    }
    assert_true(band_number(&t, k, "lwir", "emitted_W_sr") > 1.0);
  }
  table_release(&t);
}

static void check_sums(const struct table *light, const struct table *parts)
{
  size_t nmaterial = parts->nrow / light->nrow / 2, row = 0;
  assert_int_equal(parts->nrow, light->nrow * 2 * nmaterial);
  for (size_t k = 0; k < light->nrow; k++)
    for (int b = 0; b < 2; b++, row += nmaterial) {
      double total = band_number(light, k, bands[b], "intensity_W_sr"), sum = 0.0;
      for (int m = 0; m < 5; m++) {
        char column[32];
        snprintf(column, sizeof column, "%s_W_sr", mechanisms[m]);
        double all = band_number(light, k, bands[b], column), of_materials = 0.0;
        for (size_t i = row; i < row + nmaterial; i++) {
          assert_string_equal(table_text(parts, i, "time_utc"), table_text(light, k, "time_utc"));
          assert_string_equal(table_text(parts, i, "band"), bands[b]);
          of_materials += table_number(parts, i, mechanisms[m]);
        }
        assert_close(of_materials, all, PRINTED * fabs(all));
        sum += all;
      }
      assert_close(sum, total, PRINTED * total);
    }
}

static void test_sums(void **state)
{
  (void)state;
  struct table light = table_read("out/lightcurve.csv"), parts = table_read("out/materials.csv");
  assert_string_equal(parts.header, MATERIALS_HEADER);
  check_sums(&light, &parts);
  table_release(&light);
  table_release(&parts);
}

/* Light between the surfaces is there when it was asked for. */
static void test_interreflection(void **state)
{
  (void)state;
  struct table light = table_read("out/lightcurve.csv");
  for (int b = 0; b < 2; b++) {
    double sum = 0.0;
    for (size_t k = 0; k < light.nrow; k++)
      sum += band_number(&light, k, bands[b], "interreflected_W_sr");
    assert_true(sum > 0.0);
  }
  table_release(&light);
}

static void test_temperatures(void **state)
{
  (void)state;
  struct table t = table_read("out/temperatures.csv");
  assert_string_equal(t.header, "time_utc" PLACE("bus") PLACE("bus.+x") PLACE("bus.-x")
                                    PLACE("bus.+y") PLACE("bus.-y") PLACE("bus.+z") PLACE("bus.-z")
                                        PLACE("material:grey_white"));
  assert_int_equal(t.nrow, 5);
  for (size_t k = 0; k < t.nrow; k++) {
    double faces = 0.0;
    for (size_t c = 1; c < t.ncolumn; c += 3) {
      double mean = table_number(&t, k, t.field[c]), low = table_number(&t, k, t.field[c + 1]),
             high = table_number(&t, k, t.field[c + 2]);
      assert_true(low <= mean * (1 + PRINTED) && mean <= high * (1 + PRINTED));
      assert_true(low > 2.7 && high < 400.0);
      if (c >= 4 && c < 22) faces += mean / 6.0;
    }
    /* six equal faces of one material: part and material are their mean */
    assert_close(table_number(&t, k, "bus.mean_K"), faces, PRINTED * faces);
    assert_close(table_number(&t, k, "material:grey_white.mean_K"), faces, PRINTED * faces);
  }
  table_release(&t);
}

/* What comes in and does not go out is stored. */
static void test_heat(void **state)
{
  (void)state;
  static const char *const terms[] = {"solar",     "albedo",   "planet",   "internal",
                                      "conducted", "radiated", "exchanged"};
  struct table t = table_read("out/heat.csv");
  assert_string_equal(t.header, HEAT_HEADER);
  assert_true(t.nrow > 0);
  for (size_t i = 0; i < t.nrow; i++) {
    double sum = 0.0, turnover = 0.0;
    for (size_t k = 0; k < sizeof terms / sizeof terms[0]; k++) {
      sum += table_number(&t, i, terms[k]);
      turnover += fabs(table_number(&t, i, terms[k]));
    }
    assert_close(sum, table_number(&t, i, "stored"), PRINTED * turnover);
    assert_true(table_number(&t, i, "radiated") < 0.0);
  }
  table_release(&t);
}

static void test_texts(void **state)
{
  (void)state;
  char *log = command_read("out/log.txt"), *cic = command_read("out/temperatures.cic"),
       *xdmf = command_read("out/run.xdmf");
  /* 6.8 min old: the error at the epoch, over 7.5 km/s */
  assert_non_null(
      strstr(log, "elements of object 27386, epoch 2016-09-06T18:00:10.965Z, 0.0 days before "
                  "the first observation: expect 1 km, 0.13 s, along the track"));
  assert_null(strstr(log, "warning"));
  assert_int_equal(strncmp(cic, "CIC_MEM_VERS = 1.0\n", 19), 0);
  /* MJD 57637 is 2016-09-06; 18:07:00 is second 65220 */
  assert_non_null(strstr(cic, "META_STOP\n\n57637 65220.000 "));
  assert_non_null(strstr(xdmf, "run.nc:/vertex_position"));
  assert_non_null(strstr(xdmf, "</Xdmf>\n"));
  free(log);
  free(cic);
  free(xdmf);
}

/* A message in JSON says what the two lines say, which is in the results, to the printed digits. */
static void test_elements_of_a_message(void **state)
{
  (void)state;
  command_write("omm.json",
                "{\"OBJECT_ID\": \"2002-009A\", \"EPOCH\": \"2016-09-06T18:00:10.965024\",\n"
                " \"MEAN_MOTION\": 14.37874790, \"ECCENTRICITY\": 0.0001254,\n"
                " \"INCLINATION\": 98.2753, \"RA_OF_ASC_NODE\": 301.2152,\n"
                " \"ARG_OF_PERICENTER\": 82.1013, \"MEAN_ANOMALY\": 278.0311,\n"
                " \"NORAD_CAT_ID\": 27386, \"BSTAR\": 1.9645e-05}\n");
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "by-message", "--set",
                 "orbit={elements: omm.json}", NULL);
  struct table lines = table_read("out/lightcurve.csv"),
               message = table_read("by-message/lightcurve.csv");
  static const char *const columns[] = {"range_km", "azimuth_deg", "elevation_deg",
                                        "phase_angle_deg"};
  assert_int_equal(message.nrow, lines.nrow);
  for (size_t k = 0; k < lines.nrow; k++)
    for (size_t c = 0; c < sizeof columns / sizeof columns[0]; c++)
      assert_close(table_number(&message, k, columns[c]), table_number(&lines, k, columns[c]),
                   1e-6);
  table_release(&lines);
  table_release(&message);
  struct command c = command_run("check", "box.yaml", "--set",
                                 "orbit={elements: {file: omm.json, object: 5}}", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "omm.json: no set of object 5; the first one is of 27386"));
  command_release(&c);
}

/* The older the elements, the more is said of them: 10 days later 11 km, more than a second. */
static void test_age_of_elements(void **state)
{
  (void)state;
  struct command c = command_run("run", "box.yaml", "--no-plots", "--out", "aged", "--set",
                                 "time.start_utc=2016-09-16T18:07:00Z", "--set",
                                 "time.stop_utc=2016-09-16T18:08:00Z", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.err, "warning: orbit: elements of object 27386"));
  assert_non_null(strstr(c.err, "10.0 days before the first observation: expect 11 km, 1.5 s, "));
  assert_non_null(strstr(c.out, "elements 10.0 days old: 11 km, 1.5 s of error"));
  char *log = command_read("aged/log.txt");
  assert_non_null(strstr(log, "expect 11 km, 1.5 s, along the track (1 sigma)"));
  command_release(&c);
  free(log);
}

/* Without a station the station's columns are empty; without an observer there is no light curve.
 */
static void test_other_observers(void **state)
{
  (void)state;
  static const char *const empty[] = {"azimuth_deg", "elevation_deg", "airmass",
                                      "sun_elevation_deg"};
  const char *station =
      "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n";
  char *text = command_edit(command_data("box.yaml"), station,
                            "  direction: {unit_gcrs: [0, 0, 1], range_km: 1000}\n");
  command_write("space.yaml", text);
  free(text);
  command_expect(0, "run", "space.yaml", "--no-plots", "--out", "space", NULL);
  struct table t = table_read("space/lightcurve.csv");
  assert_string_equal(t.header, LIGHTCURVE_HEADER);
  for (size_t k = 0; k < t.nrow; k++) {
    for (size_t i = 0; i < sizeof empty / sizeof empty[0]; i++)
      assert_string_equal(table_text(&t, k, empty[i]), "");
    assert_close(table_number(&t, k, "range_km"), 1000.0, 1e-6);
    assert_true(table_number(&t, k, "lwir_irradiance_W_m2") > 0.0);
  }
  table_release(&t);
  text = command_edit(command_edit(command_data("box.yaml"), station, ""), "observer:\n", "");
  command_write("alone.yaml", text);
  free(text);
  command_expect(0, "run", "alone.yaml", "--no-plots", "--out", "alone", NULL);
  assert_false(command_exists("alone/lightcurve.csv"));
  assert_false(command_exists("alone/materials.csv"));
  assert_true(command_exists("alone/temperatures.csv"));
  assert_true(command_exists("alone/run.nc"));
}

static double said(const struct command *c, const char *band, const char *what, const char *text)
{
  const char *at = strstr(c->out, band);
  at = at != NULL ? strstr(at, what) : NULL;
  at = at != NULL ? strstr(at, text) : NULL;
  if (at == NULL) fail_msg("no '%s', '%s', '%s' in\n%s", band, what, text, c->out);
  return strtod(at + strlen(text), NULL);
}

static int by_size(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The Monte-Carlo error that a run states of each band is that of its table: the median, and how
 * many instants of those with light are above 5 %. */
static void test_error_stated(void **state)
{
  (void)state;
  struct command text = command_run("run", "two_parts.yaml", "--without", "umbra_scatter",
                                    "--no-plots", "--out", "out", "--force", NULL);
  struct command json = command_run("run", "two_parts.yaml", "--without", "umbra_scatter",
                                    "--no-plots", "--out", "out", "--json", NULL);
  struct table t = table_read("out/lightcurve.csv");
  for (size_t b = 0; b < 2; b++) {
    double error[16], above = 0.0;
    size_t n = 0;
    assert_true(t.nrow <= 16);
    for (size_t k = 0; k < t.nrow; k++) {
      double total = band_number(&t, k, bands[b], "intensity_W_sr");
      if (!(total > 0.0)) continue;
      error[n] = band_number(&t, k, bands[b], "stderr_W_sr") / total;
      above += error[n++] > 0.05 ? 1.0 : 0.0;
    }
    qsort(error, n, sizeof *error, by_size);
    double median = 0.5 * (error[(n - 1) / 2] + error[n / 2]);
    char name[2][32];
    snprintf(name[0], sizeof name[0], "\"name\": \"%s\"", bands[b]);
    snprintf(name[1], sizeof name[1], "\n%-5s ", bands[b]);
    assert_true(fabs(said(&json, name[0], "", "\"relative_error_median\": ") - median) <=
                1e-6 * median);
    assert_true(said(&json, name[0], "", "\"instants_above_5_percent\": ") == above);
    assert_true(fabs(said(&text, name[1], "Monte-Carlo", " error ") - 100.0 * median) <=
                0.05 * 100.0 * median); /* two digits */
    assert_true(said(&text, name[1], "Monte-Carlo", "above 5 % at ") == above);
    assert_true((b == 0) == (above > 0.0 && above < (double)n));
  }
  table_release(&t);
  command_release(&text);
  command_release(&json);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_lightcurve, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_sums, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_sums, enter_two_parts, command_leave),
      cmocka_unit_test_setup_teardown(test_interreflection, enter_two_parts, command_leave),
      cmocka_unit_test_setup_teardown(test_temperatures, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_heat, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_heat, enter_two_parts, command_leave),
      cmocka_unit_test_setup_teardown(test_texts, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_age_of_elements, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_elements_of_a_message, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_other_observers, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_error_stated, enter_two_parts, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
