/* The files of a run: what stands in them, that they add up, and that other programs can read
 * them. */
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

/* CSV numbers have nine digits, so that a sum of five rounds to 5 x 5e-10 of the largest at most.
 */
#define PRINTED 1e-8

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

static const char *const bands[] = {"vis", "lwir"};
static const char *const mechanisms[] = {"sun", "earth", "emitted", "interreflected", "other"};

static int enter_run(void **state, const char *scenario)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data(scenario);
  command_expect(0, "run", scenario, "--no-plots", "--out", "out", NULL);
  return 0;
}
static int enter_box(void **state) { return enter_run(state, "box.yaml"); }
static int enter_two_parts(void **state) { return enter_run(state, "two_parts.yaml"); }

static double band_number(const struct table *t, size_t row, const char *band, const char *what)
{
  char column[64];
  snprintf(column, sizeof column, "%s_%s", band, what);
  return table_number(t, row, column);
}

static const char *band_text(const struct table *t, size_t row, const char *band, const char *what)
{
  char column[64];
  snprintf(column, sizeof column, "%s_%s", band, what);
  return table_text(t, row, column);
}

/* The Sun is down behind the Earth until 18:10:04.9 (umbra passes); the satellite rises at
 * 18:07:50. Without the Earth's air the Sun term is exactly zero until then and the heat is not;
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
      assert_true((band_number(&t, k, bands[b], "sun_W_sr") > 0.0) == lit);
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
  assert_non_null(strstr(log,
                         "TLE of object 27386, epoch 2016-09-06T18:00:10.965Z, 0.0 days before "
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
  NC(nc_close(file));
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

/* The older the elements, the more is said of them: 10 days later 11 km, more than a second. */
static void test_age_of_elements(void **state)
{
  (void)state;
  struct command c = command_run("run", "box.yaml", "--no-plots", "--out", "aged", "--set",
                                 "time.start_utc=2016-09-16T18:07:00Z", "--set",
                                 "time.stop_utc=2016-09-16T18:08:00Z", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.err, "warning: orbit: TLE of object 27386"));
  assert_non_null(strstr(c.err, "10.0 days before the first observation: expect 11 km, 1.5 s, "));
  assert_non_null(strstr(c.out, "two-line elements 10.0 days old: 11 km, 1.5 s of error"));
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

/* A band's panel draws from the column that the table's header calls so; gnuplot counts from 1. */
static void expect_drawn(const char *script, const char *band, const char *column)
{
  struct table t = table_read("drawn/lightcurve.csv");
  char heading[32], wanted[32];
  size_t c = 0;
  while (c < t.ncolumn && strcmp(t.field[c], column) != 0) c++;
  assert_true(c < t.ncolumn);
  snprintf(heading, sizeof heading, "'%s ", band);
  snprintf(wanted, sizeof wanted, "v(%zu)", c + 1);
  const char *panel = strstr(script, heading);
  if (panel == NULL) fail_msg("no %s in plots.gp", heading);
  const char *plot = strstr(panel, "plot 'lightcurve.csv'"), *drawn = strstr(plot, wanted);
  if (drawn == NULL || drawn > strchr(plot, '\n'))
    fail_msg("%s: %s, %s, is not drawn", band, wanted, column);
  table_release(&t);
}

/* Every mechanism that is seen beside the total, and no other, has its curve and its name: above
 * the lower end of a logarithmic axis, above a hundredth of the highest total else. Returns how
 * many. */
static size_t expect_named(const char *folder, const char *band, const char *scale)
{
  static const struct {
    const char *column, *name;
  } mechanism[] = {{"sun", "Sun"},
                   {"earth", "Earth"},
                   {"emitted", "emitted"},
                   {"interreflected", "interreflected"},
                   {"other", "Moon"}};
  char path[64], text[64];
  size_t named = 0;
  snprintf(path, sizeof path, "%s/plots.gp", folder);
  char *script = command_read(path);
  snprintf(path, sizeof path, "%s/lightcurve.csv", folder);
  struct table t = table_read(path);
  snprintf(text, sizeof text, "'%s ", band);
  char *panel = strstr(script, text), *plot = strstr(panel, "plot 'lightcurve.csv'");
  *strchr(plot, '\n') = '\0';
  const char *axis = strstr(panel, scale);
  if (axis == NULL || axis > plot) fail_msg("%s, %s: no %s in\n%s", folder, band, scale, panel);
  snprintf(text, sizeof text, "%s_intensity_W_sr", band);
  double highest = 0.0, share = strcmp(scale, "\nset logscale y") == 0 ? 1e-5 : 0.01;
  for (size_t k = 0; k < t.nrow; k++) highest = fmax(highest, table_number(&t, k, text));
  for (size_t m = 0; m < sizeof mechanism / sizeof mechanism[0]; m++) {
    double most = 0.0;
    snprintf(text, sizeof text, "%s_%s_W_sr", band, mechanism[m].column);
    for (size_t k = 0; k < t.nrow; k++) most = fmax(most, table_number(&t, k, text));
    snprintf(text, sizeof text, "(v(%zu)) with lines", 1 + table_column(&t, text));
    const char *curve = strstr(plot, text);
    snprintf(text, sizeof text, " title '%s'", mechanism[m].name);
    if ((curve != NULL) != (most > share * highest) ||
        (strstr(plot, text) != NULL) != (curve != NULL))
      fail_msg("%s, %s: '%s' reaches %g of %g in\n%s", folder, band, mechanism[m].name, most,
               highest, plot);
    named += curve != NULL;
  }
  table_release(&t);
  free(script);
  return named;
}

/* Sunlight and heat; the Moon alone in the umbra, and beside a low Sun and a bright Earth; on
 * logarithmic axes, above their lower end and below it; light between surfaces. */
static void test_mechanisms_named(void **state)
{
  (void)state;
  static const char log[] = "\nset logscale y", linear[] = "\nunset logscale y";
  static const struct {
    const char *start, *stop, *step, *outside, *attitude;
    size_t vis, lwir;
    const char *scale;
  } cases[] = {
      {"2016-09-06T18:07:00Z", "2016-09-06T18:11:00Z", "60", "grey_white", "[{lvlh: {}}]", 1, 2,
       linear},
      {"2016-09-06T18:07:00Z", "2016-09-06T18:09:00Z", "60", "grey_white", "[{lvlh: {}}]", 1, 2,
       linear},
      {"2016-09-16T20:30:00Z", "2016-09-16T20:33:00Z", "60", "grey_white", "[{lvlh: {}}]", 2, 2,
       linear},
#define SPUN(period)                                                                               \
  "[{spin: {axis_gcrs: [0.3, 0.2, 0.9], axis_body: [0, 0.6, 0.8], period_s: " period "}}]"
      {"2016-09-16T20:18:00Z", "2016-09-16T20:21:40Z", "5", "cell_silicon", SPUN("90"), 2, 2, log},
      {"2016-09-16T20:18:00Z", "2016-09-16T20:21:50Z", "5", "cell_silicon", SPUN("170"), 1, 2, log},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char set[5][128];
    snprintf(set[0], sizeof set[0], "time.start_utc=%s", cases[i].start);
    snprintf(set[1], sizeof set[1], "time.stop_utc=%s", cases[i].stop);
    snprintf(set[2], sizeof set[2], "time.step_s=%s", cases[i].step);
    snprintf(set[3], sizeof set[3], "parts.bus.outside=%s", cases[i].outside);
    snprintf(set[4], sizeof set[4], "attitude=%s", cases[i].attitude);
    command_expect(0, "run", "box.yaml", "--force", "--out", "drawn", "--set", set[0], "--set",
                   set[1], "--set", set[2], "--set", set[3], "--set", set[4], NULL);
    assert_int_equal(expect_named("drawn", "vis", cases[i].scale), cases[i].vis);
    assert_int_equal(expect_named("drawn", "lwir", linear), cases[i].lwir);
  }
  command_copy_data("two_parts.yaml");
  command_expect(0, "run", "two_parts.yaml", "--out", "two", NULL);
  assert_int_equal(expect_named("two", "vis", linear), 2);
  assert_int_equal(expect_named("two", "lwir", linear), 3);
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
  struct command text =
      command_run("run", "two_parts.yaml", "--no-plots", "--out", "out", "--force", NULL);
  struct command json =
      command_run("run", "two_parts.yaml", "--no-plots", "--out", "out", "--json", NULL);
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

/* With gnuplot three pictures, each of three kinds; without it a warning and everything else. */
static void test_pictures(void **state)
{
  (void)state;
  static const char *const names[] = {"lightcurve", "temperatures", "satellite"};
  static const struct {
    const char *name, *magic;
  } kinds[] = {{"png", "\x89PNG\r\n\x1a\n"}, {"svg", "<?xml"}, {"pdf", "%PDF-"}};
  struct command c = command_run("run", "box.yaml", "--out", "drawn", NULL);
  assert_int_equal(c.code, 0);
  bool gnuplot = strstr(c.err, "gnuplot is not installed") == NULL;
  if (gnuplot) assert_string_equal(c.err, "");
  for (size_t i = 0; i < 9; i++) {
    char path[64];
    size_t length;
    snprintf(path, sizeof path, "drawn/%s.%s", names[i / 3], kinds[i % 3].name);
    assert_int_equal(command_exists(path), gnuplot);
    if (!gnuplot) continue;
    char *bytes = command_read_bytes(path, &length);
    assert_true(length > 1000 &&
                memcmp(bytes, kinds[i % 3].magic, strlen(kinds[i % 3].magic)) == 0);
    free(bytes);
  }
  if (!gnuplot) print_message("gnuplot is not installed: pictures not looked at\n");
  command_release(&c);
  /* magnitudes of the visible band alone, from its own column (the ninth of its nine) */
  char *script = command_read("drawn/plots.gp");
  char *first = strstr(script, "'AB magnitude'");
  assert_non_null(first);
  assert_null(strstr(first + 1, "'AB magnitude'"));
  assert_non_null(strstr(first, "using (x(1)):17 with lines"));
  assert_non_null(strstr(script, "vis 0.38–0.78 µm"));
  expect_drawn(script, "vis", "vis_sun_W_sr");
  expect_drawn(script, "lwir", "lwir_intensity_W_sr");
  expect_drawn(script, "lwir", "lwir_stderr_W_sr");
  expect_drawn(script, "lwir", "lwir_emitted_W_sr");
  free(script);
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
      cmocka_unit_test_setup_teardown(test_netcdf, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_netcdf_is_the_tables, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_netcdf_leap_second, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_long_scenario, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_age_of_elements, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_long_names, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_other_observers, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_mechanisms_named, enter_box, command_leave),
      cmocka_unit_test_setup_teardown(test_error_stated, enter_two_parts, command_leave),
      cmocka_unit_test_setup_teardown(test_pictures, enter_box, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
