/* Grids of the Earth from files: what a grid is sampled from comes back, what is missing is
 * Knocke's, and what is no grid is refused with file, place and what is accepted. */
#include "environment/map.h"

#include <netcdf.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

#include "base/core/constants.h"
#include "base/core/file_snapshot.h"
#include "environment/ground_view.h"
#include "environment/knocke.h"

#define DAY     86400.0
#define EQUINOX (6107.5 * DAY) /* 2016-09-21 0 h */

static struct um_context *context;
static char path[64];

static int begin(void **state)
{
  (void)state;
  snprintf(path, sizeof path, "environment_map_%ld.data", (long)getpid());
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int end(void **state)
{
  (void)state;
  remove(path);
  um_core_context_destroy(&context);
  return 0;
}

static void write_text(const char *text)
{
  FILE *f = fopen(path, "w");
  assert_non_null(f);
  fputs(text, f);
  fclose(f);
}

static struct um_environment_map *read_map(void)
{
  struct um_environment_map *map = NULL;
  if (um_environment_map_read(context, path, EQUINOX, &map) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return map;
}

static struct um_environment_ground at(const struct um_environment_map *map, double latitude,
                                       double longitude, double month)
{
  struct um_environment_ground g = {-1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0};
  um_environment_map_at(map, latitude * UM_DEG, longitude * UM_DEG, month, &g);
  return g;
}

/* Twelve months, every 5 deg, of Knocke's albedo and longwave at the middle of each month, read in
 * any order of rows. Between nodes: 1/8 step^2 |second derivative|: 0.29 * 3 * (5 deg)^2/8 = 8e-4
 * of albedo in latitude; in time 0.1 (30 deg)^2/8 = 3.4e-3, and the same with 0.07 * 340 and 0.18 *
 * 3 * 340 for longwave, W/m^2, beside the year's 3 % of distance that a year like any other has. */
static void sampled_knocke_is_knocke(void **state)
{
  (void)state;
  FILE *f = fopen(path, "w");
  fputs("# made by a test\nlatitude_deg,month,longitude_deg,olr_W_m2,albedo\n", f);
  for (int i = 35; i >= 0; i--)
    for (int m = 0; m < 12; m++)
      for (int l = -180; l < 180; l += 90) {
        double latitude = -87.5 + 5.0 * i, albedo, emissivity;
        double day = 5844.5 - 1.0 + 30.4375 * (m + 0.5); /* of 2016 */
        um_environment_knocke(sin(latitude * UM_DEG), um_environment_knocke_season(day * DAY),
                              &albedo, &emissivity);
        fprintf(f, "%.9g,%d,%d,%.9g,%.9g\n", latitude, m + 1, l, emissivity * 1361.0 / 4.0, albedo);
      }
  fclose(f);
  struct um_environment a, b;
  um_environment_defaults(&a);
  um_environment_defaults(&b);
  struct um_environment_map *map = read_map();
  a.earth = UM_EARTH_KNOCKE;
  b.earth = UM_EARTH_MAP;
  b.map = map;
  double worst[2] = {0};
  for (int i = 0; i < 300; i++) {
    struct um_environment_globe globe = {
        .t_tai = (5844.5 + 1.22 * i) * DAY, .pole = {0, 0, 1}, .greenwich = {1, 0, 0}};
    double z = 0.99 * cos(2.7 * i), q = sqrt(1.0 - z * z);
    struct um_vec3 up = {q * cos(0.7 * i), q * sin(0.7 * i), z};
    struct um_vec3 r = um_vec3_scale(up, UM_EARTH_RADIUS + 765e3), down = um_vec3_scale(up, -1.0);
    struct um_environment_earth_flux x, y;
    struct um_vec3 sun = um_vec3_unit(um_vec3(1.0, 0.0, 0.3));
    um_environment_earth_flux(&a, &globe, r, sun, UM_AU, &down, 1, &x);
    um_environment_earth_flux(&b, &globe, r, sun, UM_AU, &down, 1, &y);
    worst[0] = fmax(worst[0], fabs(x.albedo - y.albedo) / 1361.0);
    worst[1] = fmax(worst[1], fabs(x.planet - y.planet));
  }
  print_message("nadir plate: albedo within %.1e, infrared within %.2f W/m^2\n", worst[0],
                worst[1]);
  check_below("albedo", worst[0], 4.2e-3);
  check_below("infrared", worst[1], 0.8 + 0.5);
  um_environment_map_destroy(context, &map);
}

/* A grid of one value is the uniform Earth, to the rounding of single precision. */
static void one_value_is_uniform(void **state)
{
  (void)state;
  write_text("latitude_deg,longitude_deg,albedo,olr_W_m2,brightness_temperature_K\n"
             "-45,0,0.3,237,270\n-45,180,0.3,237,270\n45,0,0.3,237,270\n45,180,0.3,237,270\n");
  struct um_environment_map *map = read_map();
  struct um_environment a, b;
  um_environment_defaults(&a);
  um_environment_defaults(&b);
  b.earth = UM_EARTH_MAP;
  b.earth_spectrum_on = false;
  b.map = map;
  const struct um_environment_globe globe = {
      .t_tai = EQUINOX, .pole = {0, 0, 1}, .greenwich = {1, 0, 0}};
  for (int i = 0; i < 60; i++) {
    double z = cos(1.9 * i), q = sqrt(1.0 - z * z);
    struct um_vec3 r = um_vec3_scale(um_vec3(q * cos(0.7 * i), q * sin(0.7 * i), z), 7.0e6);
    struct um_vec3 n = um_vec3_unit(um_vec3(cos(2.2 * i), sin(1.2 * i), cos(0.5 * i)));
    struct um_environment_earth_flux x, y;
    um_environment_earth_flux(&a, &globe, r, um_vec3(1, 0, 0), UM_AU, &n, 1, &x);
    um_environment_earth_flux(&b, &globe, r, um_vec3(1, 0, 0), UM_AU, &n, 1, &y);
    check_near("albedo", y.albedo, x.albedo, 1e-7 * 400.0);
    check_near("infrared", y.planet, x.planet, 1e-7 * 237.0);
    if (x.view_factor > 0.0) check_near("brightness", y.brightness, 270.0, 1e-4);
  }
  um_environment_map_destroy(context, &map);
}

/* Linear in all three, round the date line and the turn of the year, constant at the poles. */
static void interpolation(void **state)
{
  (void)state;
  write_text("month,latitude_deg,longitude_deg,olr_W_m2\n"
             "1,-45,90,100\n1,-45,270,200\n1,45,90,140\n1,45,270,240\n"
             "7,-45,90,110\n7,-45,270,210\n7,45,90,150\n7,45,270,250\n");
  struct um_environment_map *map = read_map();
  check_near("node", at(map, -45, 90, 0).longwave, 100, 1e-5);
  check_near("the same, once round", at(map, -45, -270, 0).longwave, 100, 1e-5);
  check_near("latitude", at(map, -22.5, 90, 0).longwave, 110, 1e-4);
  check_near("pole", at(map, -90, 90, 0).longwave, 100, 1e-5);
  check_near("longitude", at(map, -45, 135, 0).longwave, 125, 1e-4);
  check_near("date line", at(map, -45, 180, 0).longwave, 150, 1e-4);
  check_near("other side", at(map, -45, 0, 0).longwave, 150, 1e-4);
  check_near("month", at(map, -45, 90, 3).longwave, 105, 1e-4);
  check_near("turn of the year", at(map, -45, 90, 10.5).longwave, 100.0 + 10.0 * 0.25, 1e-4);
  check_near("before January", at(map, -45, 90, -0.5).longwave, 100.0 + 10.0 / 12.0, 1e-4);
  check_near("window", at(map, 45, 270, 0).brightness, um_environment_window_temperature(240.0),
             1e-4);
  assert_true(at(map, 45, 270, 0).albedo == -1.0); /* not in the file: left as it was */
  if (strstr(um_core_log_text(context), "no albedo: that of Knocke") == NULL)
    fail_msg("log: %s", um_core_log_text(context));
  um_environment_map_destroy(context, &map);
}

/* Zones alone, and a field without a value. */
static void missing_is_knocke(void **state)
{
  (void)state;
  write_text("latitude_deg,albedo\n-60,\n0,0.25\n60,0.5\n");
  struct um_environment_map *map = read_map();
  double albedo, unused;
  um_environment_knocke(sin(-60 * UM_DEG), um_environment_knocke_season(15.0 * DAY), &albedo,
                        &unused);
  check_near("missing", at(map, -60, 33, 0).albedo, albedo, 1e-3);
  check_near("there", at(map, 0, 33, 5).albedo, 0.25, 1e-7);
  if (strstr(um_core_log_text(context), "albedo missing on 25 % of the Earth") == NULL)
    fail_msg("log: %s", um_core_log_text(context));
  um_environment_map_destroy(context, &map);
}

/* As CERES EBAF has it, small: months since 2015-12, 4 latitudes from the north, 8 longitudes from
 * 0; reflected and incoming sunlight, emitted radiation; `what` breaks it. */
static void write_ceres(const char *what)
{
  enum { TIME = 25, LAT = 4, LON = 8 };
  int file, axis[3], id[6];
  double lat[LAT] = {67.5, 22.5, -22.5, -67.5}, lon[LON], time[TIME];
  static float value[3][TIME][LAT][LON];
  for (int l = 0; l < LON; l++) lon[l] = 22.5 + 45.0 * l;
  if (strcmp(what, "latitudes") == 0) lat[2] = 80.0;
  for (int t = 0; t < TIME; t++) {
    time[t] = 15.0 + 30.4375 * t;
    for (int i = 0; i < LAT; i++)
      for (int l = 0; l < LON; l++) {
        bool dark = i == 3;
        value[1][t][i][l] = dark ? 1.0F : 400.0F;
        value[0][t][i][l] = (float)(0.1 + 0.01 * l + 0.02 * i + (t >= 13 ? 0.2 : 0.0)) * 400.0F;
        value[2][t][i][l] = (float)(200.0 + 5.0 * i + l + t);
      }
  }
  value[2][9][1][2] = -999.0F;
  if (strcmp(what, "value") == 0) value[2][9][1][3] = 5000.0F;
  assert_int_equal(nc_create(path, NC_NETCDF4 | NC_CLOBBER, &file), NC_NOERR);
  nc_def_dim(file, "time", TIME, &axis[0]);
  nc_def_dim(file, "lat", LAT, &axis[1]);
  nc_def_dim(file, "lon", LON, &axis[2]);
  nc_def_var(file, "time", NC_DOUBLE, 1, &axis[0], &id[0]);
  nc_def_var(file, strcmp(what, "no lat") == 0 ? "width" : "lat", NC_DOUBLE, 1, &axis[1], &id[1]);
  nc_def_var(file, "lon", NC_DOUBLE, 1, &axis[2], &id[2]);
  if (strcmp(what, "axes") == 0) {
    int other[3] = {axis[0], axis[2], axis[1]};
    nc_def_var(file, "toa_lw_all_mon", NC_FLOAT, 3, other, &id[5]);
  } else if (strcmp(what, "nothing") != 0) {
    nc_def_var(file, "toa_sw_all_mon", NC_FLOAT, 3, axis, &id[3]);
    nc_def_var(file, "solar_mon", NC_FLOAT, 3, axis, &id[4]);
    nc_def_var(file, "toa_lw_all_mon", NC_FLOAT, 3, axis, &id[5]);
    float fill = -999.0F;
    nc_put_att_float(file, id[5], "_FillValue", NC_FLOAT, 1, &fill);
  }
  const char *unit = strcmp(what, "unit") == 0 ? "fortnights" : "days since 2015-12-01 00:00:00";
  nc_put_att_text(file, id[0], "units", strlen(unit), unit);
  nc_enddef(file);
  nc_put_var_double(file, id[0], time);
  nc_put_var_double(file, id[1], lat);
  nc_put_var_double(file, id[2], lon);
  if (strcmp(what, "axes") != 0 && strcmp(what, "nothing") != 0)
    for (int q = 0; q < 3; q++) nc_put_var_float(file, id[3 + q], &value[q][0][0][0]);
  assert_int_equal(nc_close(file), NC_NOERR);
}

/* Of two years the months within half a year of 2016-09-21: April 2016 (4) to February 2017 (14).
 */
static void ceres(void **state)
{
  (void)state;
  write_ceres("");
  struct um_environment_map *map = read_map();
  check_near("May 2016", at(map, 67.5, 22.5, 4).albedo, 0.1, 1e-6);
  check_near("column", at(map, 67.5, 22.5 + 45.0 * 6, 4).albedo, 0.16, 1e-6);
  check_near("row", at(map, -22.5, 22.5, 4).albedo, 0.14, 1e-6);
  check_near("February 2017", at(map, 67.5, 22.5, 1).albedo, 0.3, 1e-6);
  check_near("longwave, September 2016", at(map, 67.5, 22.5 + 90.0, 8).longwave, 200 + 2 + 9, 1e-4);
  check_near("fill value", at(map, 22.5, 112.5, 8).longwave, 240.0, 40.0);
  assert_true(fabs(at(map, 22.5, 112.5, 8).longwave - 216.0) > 1.0);
  double albedo, unused;
  um_environment_knocke(sin(-67.5 * UM_DEG), um_environment_knocke_season(-15.0 * DAY + 366 * DAY),
                        &albedo, &unused);
  check_near("dark: Knocke", at(map, -67.5, 60, 11).albedo, albedo, 2e-3);
  if (strstr(um_core_log_text(context), "albedo missing on 15 % of the Earth") == NULL)
    fail_msg("log: %s", um_core_log_text(context));
  um_environment_map_destroy(context, &map);
}

static void count(void *n, const char *file, uint64_t digest)
{
  (void)digest;
  *(int *)n += strcmp(file, path) == 0;
}

/* A library reads the file: it is among the held all the same, and may not change meanwhile. */
static void ceres_held(void **state)
{
  (void)state;
  struct um_environment_map *map;
  int n = 0;
  assert_int_equal(um_core_snapshot_begin(context), UM_OK);
  write_ceres("");
  map = read_map();
  um_environment_map_destroy(context, &map);
  um_core_snapshot_each(context, count, &n);
  assert_int_equal(n, 1);
  write_ceres("nothing");
  assert_int_equal(um_environment_map_read(context, path, EQUINOX, &map), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "has changed since it was read first"));
  um_core_message_clear(context);
  um_core_snapshot_end(context);
}

static void refused(const char *what)
{
  struct um_environment_map *map = NULL;
  um_core_message_clear(context);
  enum um_status status = um_environment_map_read(context, path, EQUINOX, &map);
  assert_null(map);
  if (status != UM_ERR_INPUT && status != UM_ERR_IO)
    fail_msg("'%s': %s", what, um_core_status_text(status));
  const char *message = um_core_message(context);
  if (strstr(message, path) == NULL || strstr(message, what) == NULL)
    fail_msg("'%s' lacks '%s' or the path", message, what);
  um_core_message_clear(context);
}

static void hostile_tables(void **state)
{
  (void)state;
  static const struct {
    const char *text, *what;
  } row[] = {
      {"", "empty"},
      {"albedo\n0.3\n", "latitude_deg"},
      {"latitude_deg,longitude_deg\n0,0\n", "accepted: rows with one or more of albedo"},
      {"latitude_deg,albedo\n", "no rows"},
      {"latitude_deg,albedo,colour\n0,0.3,1\n", "column 'colour'; accepted: month"},
      {"latitude_deg,albedo\n0,0.3\n91,0.3\n",
       ":3: column 'latitude_deg': 91; accepted: -90 to 90"},
      {"month,latitude_deg,albedo\n1.5,0,0.3\n", "accepted: whole numbers from 1 to 12"},
      {"month,latitude_deg,albedo\n13,0,0.3\n", "accepted: whole numbers from 1 to 12"},
      {"latitude_deg,longitude_deg,albedo\n0,361,0.3\n", "accepted: -180 to 360"},
      {"latitude_deg,albedo\n0,1.3\n", ":2: column 'albedo': 1.3; accepted: 0 to 1 1, or nothing"},
      {"latitude_deg,albedo\n0,nan\n", "'nan' is not a finite number"},
      {"latitude_deg,olr_W_m2\n0,-3\n", "accepted: 0 to 600 W/m^2"},
      {"latitude_deg,brightness_temperature_K\n0,20\n", "accepted: 100 to 400 K"},
      {"latitude_deg,longitude_deg,albedo\n0,0,0.3\n0,90,0.3\n45,0,0.3\n",
       "every combination once"},
      {"latitude_deg,longitude_deg,albedo\n0,0,.3\n0,9,.3\n0,0,.3\n5,9,.3\n", ":4: column"},
  };
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    write_text(row[i].text);
    refused(row[i].what);
  }
  remove(path);
  refused("No such file");
}

static void hostile_netcdf(void **state)
{
  (void)state;
  static const char *const row[][2] = {
      {"no lat", "accepted: lat, lon and time"},
      {"latitudes", "variable 'lat': value 3, 80; accepted: ascending or descending"},
      {"axes", "variable 'toa_lw_all_mon' has other axes; accepted: (time, lat, lon)"},
      {"nothing", "accepted: toa_sw_all_mon with solar_mon"},
      {"unit", "variable 'time' is in 'fortnights'; accepted: days"},
      {"value", "variable 'toa_lw_all_mon': 5000 in the cell 12 of month 9; accepted: 0 to 600"},
  };
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    write_ceres(row[i][0]);
    refused(row[i][1]);
  }
  write_text("CDF\001 and then nothing that is netCDF");
  refused("netCDF:");
  write_text("\211HDF\r\n\032\n and then nothing that is HDF");
  refused("netCDF:");
}

/* A file cut short anywhere is refused or read, never a crash of this process. */
static void cut_short(void **state)
{
  (void)state;
  write_ceres("");
  FILE *f = fopen(path, "rb");
  static char bytes[1 << 20];
  size_t n = fread(bytes, 1, sizeof bytes, f);
  fclose(f);
  for (size_t cut = 8; cut < n; cut += n / 12) {
    struct um_environment_map *map = NULL;
    f = fopen(path, "wb");
    fwrite(bytes, 1, cut, f);
    fclose(f);
    um_core_message_clear(context);
    enum um_status status = um_environment_map_read(context, path, EQUINOX, &map);
    assert_true((status == UM_OK) == (map != NULL));
    if (status != UM_OK && strstr(um_core_message(context), path) == NULL)
      fail_msg("%s", um_core_message(context));
    um_environment_map_destroy(context, &map);
  }
  um_core_message_clear(context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sampled_knocke_is_knocke),
      cmocka_unit_test(one_value_is_uniform),
      cmocka_unit_test(interpolation),
      cmocka_unit_test(missing_is_knocke),
      cmocka_unit_test(ceres),
      cmocka_unit_test(ceres_held),
      cmocka_unit_test(hostile_tables),
      cmocka_unit_test(hostile_netcdf),
      cmocka_unit_test(cut_short),
  };
  return cmocka_run_group_tests(tests, begin, end);
}
