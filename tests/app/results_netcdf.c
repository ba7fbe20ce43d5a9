/* run.nc by the netCDF library: what it holds is that of the tables, in units and at times that
 * other programs can read. */
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/app/box_run.h"

#define NC(call) assert_int_equal(call, NC_NOERR)

static void expect_dimensions(int file)
{
  static const char *const names[] = {"time", "facet", "node",       "part",     "material",
                                      "band", "xyz",   "wavelength", "mechanism"};
  static const size_t lengths[] = {5, 12, 6, 8, 1, 2, 3, 8, 5};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    int id;
    size_t length;
    if (nc_inq_dimid(file, names[i], &id) != NC_NOERR) fail_msg("no dimension %s", names[i]);
    NC(nc_inq_dimlen(file, id, &length));
    if (length != lengths[i]) fail_msg("%s is %zu, expected %zu", names[i], length, lengths[i]);
  }
}

static void expect_attribute(int file, int variable, const char *name)
{
  char of[NC_MAX_NAME + 1] = "the file";
  size_t length = 0;
  if (variable != NC_GLOBAL) NC(nc_inq_varname(file, variable, of));
  if (nc_inq_attlen(file, variable, name, &length) != NC_NOERR || length == 0)
    fail_msg("%s has no %s", of, name);
}

/* Intensities in run.nc are those of materials.csv, where they are rounded to nine digits. */
static void compare_intensity(int file)
{
  struct table parts = table_read("out/materials.csv");
  double intensity[5][2][1][5];
  int id;
  NC(nc_inq_varid(file, "intensity", &id));
  NC(nc_get_var_double(file, id, &intensity[0][0][0][0]));
  for (size_t k = 0; k < 5; k++)
    for (size_t b = 0; b < 2; b++)
      for (size_t m = 0; m < 5; m++) {
        double csv = table_number(&parts, 2 * k + b, mechanisms[m]);
        assert_close(intensity[k][b][0][m], csv, PRINTED * fabs(csv));
      }
  table_release(&parts);
}

/* Spectra add up to the intensities, to the rounding of single precision, 6e-8. */
static void compare_spectra(int file)
{
  enum { MOST = 256 };
  static double spectral[5 * MOST * 5], width[MOST], transmission[MOST];
  double intensity[5][2][1][5], sum[5][2][5] = {0};
  int id, axis, band[MOST];
  size_t n;
  NC(nc_inq_dimid(file, "wavelength", &axis));
  NC(nc_inq_dimlen(file, axis, &n));
  assert_true(n > 0 && n <= MOST);
  const struct {
    const char *name;
    double *to;
  } table[] = {{"spectral_intensity", spectral},
               {"wavelength_width", width},
               {"transmission", transmission},
               {"intensity", &intensity[0][0][0][0]}};
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
    NC(nc_inq_varid(file, table[i].name, &id));
    NC(nc_get_var_double(file, id, table[i].to));
  }
  NC(nc_inq_varid(file, "wavelength_band", &id));
  NC(nc_get_var_int(file, id, band));
  for (size_t k = 0; k < 5; k++)
    for (size_t i = 0; i < n; i++)
      for (size_t m = 0; m < 5; m++)
        sum[k][band[i]][m] += spectral[(k * n + i) * 5 + m] * width[i] * transmission[i];
  for (size_t k = 0; k < 5; k++)
    for (size_t b = 0; b < 2; b++)
      for (size_t m = 0; m < 5; m++)
        assert_close(sum[k][b][m], intensity[k][b][0][m], 6e-8 * fabs(intensity[k][b][0][m]));
}

/* Index of a name in the coordinate of a dimension, as a reader finds it that selects by name. */
static size_t coordinate_find(int file, const char *dimension, const char *name)
{
  int id, axis, axes[1];
  size_t n, found = (size_t)-1;
  NC(nc_inq_dimid(file, dimension, &axis));
  NC(nc_inq_dimlen(file, axis, &n));
  NC(nc_inq_varid(file, dimension, &id));
  NC(nc_inq_varndims(file, id, axes));
  assert_int_equal(axes[0], 1);
  NC(nc_inq_vardimid(file, id, axes));
  assert_int_equal(axes[0], axis);
  char **names = calloc(n, sizeof *names);
  assert_non_null(names);
  NC(nc_get_var_string(file, id, names));
  for (size_t i = 0; i < n; i++) {
    if (strcmp(names[i], name) == 0) found = i;
    for (size_t j = 0; j < i; j++) assert_string_not_equal(names[i], names[j]);
  }
  NC(nc_free_string(n, names));
  free(names);
  if (found == (size_t)-1) fail_msg("%s has no '%s'", dimension, name);
  return found;
}

/* Variable of `time`, and of the entry `name` of one more dimension (NULL: none). */
static double at(int file, const char *variable, size_t k, const char *dimension, const char *name)
{
  const size_t index[2] = {k, name == NULL ? 0 : coordinate_find(file, dimension, name)};
  double value;
  int id, n;
  NC(nc_inq_varid(file, variable, &id));
  NC(nc_inq_varndims(file, id, &n));
  assert_int_equal(n, name == NULL ? 1 : 2);
  NC(nc_get_var1_double(file, id, index, &value));
  return value;
}

/* A field of a table and a number beside it: empty and NaN, or equal to nine digits. */
static void expect_field(const struct table *t, size_t row, const char *column, double value)
{
  if (table_text(t, row, column)[0] == '\0') {
    if (!isnan(value)) fail_msg("row %zu, %s: empty, run.nc has %g", row, column, value);
    return;
  }
  double csv = table_number(t, row, column);
  if (!(fabs(value - csv) <= PRINTED * fabs(csv)))
    fail_msg("row %zu, %s: %.12g, run.nc has %.12g", row, column, csv, value);
}

/* What a reader without leap seconds makes of `time`: days of 86400 s behind the date in its units
 * (CF 1.8, 4.4), here by the C library's calendar; to the millisecond. */
static void decode_time(int file, size_t k, char out[64])
{
  char units[64] = "", calendar[32] = "";
  int id, year, month, day;
  double value;
  NC(nc_inq_varid(file, "time", &id));
  NC(nc_get_att_text(file, id, "units", units));
  NC(nc_get_att_text(file, id, "calendar", calendar));
  assert_string_equal(calendar, "standard");
  int end = 0; /* stays 0 where the hour is another */
  assert_int_equal(sscanf(units, "seconds since %d-%d-%d 00:00:00%n", &year, &month, &day, &end),
                   3);
  assert_true(end > 0 && units[end] == '\0');
  NC(nc_get_var1_double(file, id, &k, &value));
  struct tm epoch = {.tm_year = year - 1900, .tm_mon = month - 1, .tm_mday = day};
  long milliseconds = lround(1e3 * value);
  assert_int_equal(setenv("TZ", "UTC0", 1), 0);
  tzset();
  time_t seconds = mktime(&epoch) + milliseconds / 1000;
  struct tm *utc = gmtime(&seconds);
  snprintf(out, 64, "%04d-%02d-%02dT%02d:%02d:%02d.%03ldZ", utc->tm_year + 1900, utc->tm_mon + 1,
           utc->tm_mday, utc->tm_hour, utc->tm_min, utc->tm_sec, milliseconds % 1000);
}

/* Opens with the library, and says of everything what it is and in which unit. */
static void test_netcdf(void **state)
{
  (void)state;
  static const char *const global[] = {"title", "version", "command", "scenario", "Conventions"};
  int file, count, id;
  double time[5];
  NC(nc_open("out/run.nc", NC_NOWRITE, &file));
  expect_dimensions(file);
  for (size_t i = 0; i < sizeof global / sizeof global[0]; i++)
    expect_attribute(file, NC_GLOBAL, global[i]);
  NC(nc_inq_nvars(file, &count));
  assert_true(count > 20);
  for (int v = 0; v < count; v++) {
    expect_attribute(file, v, "units");
    expect_attribute(file, v, "long_name");
  }
  NC(nc_inq_varid(file, "time", &id));
  NC(nc_get_var_double(file, id, time));
  for (int k = 1; k < 5; k++) assert_close(time[k] - time[0], 60.0 * k, 1e-6);
  compare_intensity(file);
  compare_spectra(file);
  NC(nc_close(file));
}

/* Everything that stands in the tables, too, found in run.nc by name. */
static void test_netcdf_is_the_tables(void **state)
{
  (void)state;
  static const struct {
    const char *column, *variable;
    double unit;
  } look[] = {{"azimuth_deg", "azimuth", 1.0},
              {"elevation_deg", "elevation", 1.0},
              {"range_km", "range", 1e-3},
              {"airmass", "airmass", 1.0},
              {"phase_angle_deg", "phase_angle", 1.0},
              {"sun_elevation_deg", "sun_elevation", 1.0},
              {"sunlit_fraction", "sunlit_fraction", 1.0}};
  static const char *const flows[] = {"solar",     "albedo",   "planet",    "internal",
                                      "conducted", "radiated", "exchanged", "stored"};
  struct table light = table_read("out/lightcurve.csv"), heat = table_read("out/heat.csv"),
               warm = table_read("out/temperatures.csv");
  int file;
  NC(nc_open("out/run.nc", NC_NOWRITE, &file));
  for (size_t k = 0; k < light.nrow; k++) {
    char time[64], name[64];
    decode_time(file, k, time);
    assert_string_equal(time, table_text(&light, k, "time_utc"));
    for (size_t i = 0; i < sizeof look / sizeof look[0]; i++)
      expect_field(&light, k, look[i].column,
                   look[i].unit * at(file, look[i].variable, k, NULL, NULL));
    assert_true(at(file, "hidden", k, NULL, NULL) == (k == 0 ? 1.0 : 0.0));
    for (int b = 0; b < 2; b++) {
      snprintf(name, sizeof name, "%s_irradiance_W_m2", bands[b]);
      expect_field(&light, k, name, at(file, "irradiance", k, "band", bands[b]));
      snprintf(name, sizeof name, "%s_mag_ab", bands[b]);
      expect_field(&light, k, name, at(file, "magnitude_ab", k, "band", bands[b]));
      snprintf(name, sizeof name, "%s_mag_vega", bands[b]);
      expect_field(&light, k, name, at(file, "magnitude_vega", k, "band", bands[b]));
      snprintf(name, sizeof name, "%s_mag_ab_1000km", bands[b]);
      expect_field(&light, k, name,
                   at(file, "magnitude_ab", k, "band", bands[b]) -
                       5.0 * log10(at(file, "range", k, NULL, NULL) * 1e-6));
    }
    for (size_t c = 1; c < warm.ncolumn; c += 3) {
      snprintf(name, sizeof name, "%.*s", (int)(strlen(warm.field[c]) - strlen(".mean_K")),
               warm.field[c]);
      expect_field(&warm, k, warm.field[c], at(file, "part_temperature", k, "part", name));
      expect_field(&warm, k, warm.field[c + 1],
                   at(file, "part_temperature_minimum", k, "part", name));
      expect_field(&warm, k, warm.field[c + 2],
                   at(file, "part_temperature_maximum", k, "part", name));
    }
    for (int side = 0; side < 6; side++) { /* lumped: each is one node */
      snprintf(name, sizeof name, "bus.%c%c", side % 2 ? '-' : '+', "xyz"[side / 2]);
      assert_true(at(file, "node_temperature", k, "node", name) ==
                  at(file, "part_temperature", k, "part", name));
    }
  }
  for (size_t row = 0; row < heat.nrow; row++)
    for (size_t i = 0; i < sizeof flows / sizeof flows[0]; i++) {
      char name[32];
      snprintf(name, sizeof name, "heat_%s", flows[i]);
      expect_field(
          &heat, row, flows[i],
          at(file, name, row * light.nrow / heat.nrow, "part", table_text(&heat, row, "node")));
    }
  (void)coordinate_find(file, "material", "grey_white");
  (void)coordinate_find(file, "mechanism", "interreflected");
  assert_int_equal(coordinate_find(file, "xyz", "z"), 2);
  assert_int_equal(coordinate_find(file, "quaternion", "w"), 0);
  NC(nc_close(file));
  table_release(&light);
  table_release(&heat);
  table_release(&warm);
}

/* Through the leap second at the end of 2016: the clock is right outside of it, inside it reads as
 * the second after, and the file says so; TAI goes on without a gap. */
static void test_netcdf_leap_second(void **state)
{
  (void)state;
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "leap", "--set",
                 "time.start_utc=2016-12-31T23:59:59Z", "--set",
                 "time.stop_utc=2017-01-01T00:00:01Z", "--set", "time.step_s=0.5", NULL);
  static const char *const expected[] = {"2016-12-31T23:59:59.000Z", "2016-12-31T23:59:59.500Z",
                                         "2017-01-01T00:00:00.000Z", "2017-01-01T00:00:00.500Z",
                                         "2017-01-01T00:00:00.000Z", "2017-01-01T00:00:00.500Z",
                                         "2017-01-01T00:00:01.000Z"};
  struct table light = table_read("leap/lightcurve.csv");
  char *cic = command_read("leap/temperatures.cic");
  char note[160] = "";
  double tai[7];
  int file, id;
  assert_int_equal(light.nrow, 7);
  assert_string_equal(table_text(&light, 2, "time_utc"), "2016-12-31T23:59:60.000Z");
  NC(nc_open("leap/run.nc", NC_NOWRITE, &file));
  NC(nc_inq_varid(file, "time_tai", &id));
  NC(nc_get_var_double(file, id, tai));
  for (size_t k = 0; k < 7; k++) {
    char time[64];
    decode_time(file, k, time);
    assert_string_equal(time, expected[k]);
    if (k != 2 && k != 3) assert_string_equal(time, table_text(&light, k, "time_utc"));
    assert_close(tai[k] - tai[0], 0.5 * (double)k, 1e-6);
  }
  /* TAI - UTC was 36 s: 2016-12-31T23:59:59 UTC is 6210 days less 1 s and 36 s after
   * 2000-01-01T00:00:00, and 12 h less after its noon */
  assert_close(tai[0], 6210.0 * 86400.0 - 1.0 + 36.0 - 43200.0, 1e-6);
  NC(nc_inq_varid(file, "time", &id));
  NC(nc_get_att_text(file, id, "leap_seconds", note));
  assert_int_equal(strncmp(note, "1 between the first and the last observation", 44), 0);
  /* MJD 57753 is 2016-12-31, which had 86401 s */
  assert_non_null(strstr(cic, "\n57753 86399.500 "));
  assert_non_null(strstr(cic, "\n57753 86400.500 "));
  assert_non_null(strstr(cic, "\n57754 0.000 "));
  NC(nc_close(file));
  free(cic);
  table_release(&light);
}

/* A scenario of more than 64 KiB, which HDF5 refuses as characters: whole, under its name. */
static void test_long_scenario(void **state)
{
  (void)state;
  enum { LINES = 2000, LINE = 51 };
  char *box = command_data("box.yaml"), *text = malloc(strlen(box) + LINES * LINE + 1), *found;
  int file;
  assert_non_null(text);
  strcpy(text, box);
  char *end = text + strlen(text);
  for (int i = 0; i < LINES; i++) end += sprintf(end, "# %048d\n", i);
  command_write("long.yaml", text);
  command_expect(0, "run", "long.yaml", "--no-plots", "--out", "long", NULL);
  char *kept = command_read("long/scenario.yaml");
  assert_true(strlen(kept) > 100000);
  NC(nc_open("long/run.nc", NC_NOWRITE, &file));
  NC(nc_get_att_string(file, NC_GLOBAL, "scenario", &found));
  assert_string_equal(found, kept);
  NC(nc_free_string(1, &found));
  NC(nc_close(file));
  free(kept);
  free(text);
  free(box);
}

/* A name may be longer than any fixed width. */
static void test_long_names(void **state)
{
  (void)state;
  char name[201], text[256];
  memset(name, 'x', 200);
  name[200] = '\0';
  char *scenario = command_data("box.yaml");
  snprintf(text, sizeof text, "name: %s", name);
  scenario = command_edit(scenario, "name: bus", text);
  command_write("long.yaml", scenario);
  free(scenario);
  command_expect(0, "run", "long.yaml", "--no-plots", "--out", "long", NULL);
  int file;
  NC(nc_open("long/run.nc", NC_NOWRITE, &file));
  assert_int_equal(coordinate_find(file, "part", name), 0);
  snprintf(text, sizeof text, "%s.+x", name);
  assert_int_equal(coordinate_find(file, "part", text), 1);
  NC(nc_close(file));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_netcdf, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_netcdf_is_the_tables, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_netcdf_leap_second, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_long_scenario, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_long_names, enter_box, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
