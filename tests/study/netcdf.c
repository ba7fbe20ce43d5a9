/* study.nc read back: a coordinate variable for every dimension, numbers where they belong, as
 * xarray's conventions want them. The result is made by hand. */
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <string.h>

#include "study/study.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define PATH "study_netcdf.nc"

static char *const names[] = {"power", "emittance"}, *const units[] = {"W", ""};
static struct um_study_quantity quantities[] = {
    {.name = "irradiance:vis",
     .unit = "W/m2",
     .of = "vis",
     .count = 3,
     .light = true,
     .asked = 1e-3},
    {.name = "irradiance:lwir",
     .unit = "W/m2",
     .of = "lwir",
     .first = 3,
     .count = 3,
     .light = true,
     .asked = 1e-3},
    {.name = "temperature:bus", .unit = "K", .of = "bus", .first = 6, .count = 3, .asked = 0.2},
};

static void need(int code)
{
  if (code != NC_NOERR) fail_msg("%s", nc_strerror(code));
}

static void test_read_back(void **state)
{
  (void)state;
  double time[] = {0.0, 1.0, 2.0}, u[8], parameter[8], value[4 * 9], nominal[9], at[] = {1.0, NAN},
         error[] = {1e-3, 2e-3, 0.1};
  char *reason[4] = {NULL, "dark", NULL, NULL};
  for (int i = 0; i < 8; i++) u[i] = i / 8.0, parameter[i] = 10.0 * i;
  for (int i = 0; i < 36; i++) value[i] = i;
  for (int i = 9; i < 18; i++) value[i] = NAN;
  for (int i = 0; i < 9; i++) nominal[i] = 100.0 + i;
  const struct um_study_result r = {.name = "n",
                                    .scenario = "s",
                                    .nparameter = 2,
                                    .npoint = 4,
                                    .wanted = 4,
                                    .nvalue = 9,
                                    .nquantity = 3,
                                    .ntime = 3,
                                    .parameter_name = (char **)(uintptr_t)names,
                                    .parameter_unit = (char **)(uintptr_t)units,
                                    .time = time,
                                    .coordinate = u,
                                    .parameter = parameter,
                                    .value = value,
                                    .reason = reason,
                                    .nominal = nominal,
                                    .at_nominal = at,
                                    .quantity = quantities,
                                    .error = error};
  FILE *out = fopen(PATH, "wb");
  assert_non_null(out);
  if (um_study_write_netcdf(context, &r, out) != UM_OK) fail_msg("%s", um_core_message(context));
  fclose(out);

  int file, id, dimension[3], n;
  size_t length;
  char name[NC_MAX_NAME + 1], text[200] = "";
  need(nc_open(PATH, NC_NOWRITE, &file));
  need(nc_inq_ndims(file, &n));
  assert_int_equal(n, 5);
  for (int d = 0; d < n; d++) { /* a coordinate variable over itself alone */
    int own, ndims;
    need(nc_inq_dim(file, d, name, &length));
    need(nc_inq_varid(file, name, &own));
    need(nc_inq_varndims(file, own, &ndims));
    assert_int_equal(ndims, 1);
    need(nc_inq_vardimid(file, own, dimension));
    assert_int_equal(dimension[0], d);
  }
  need(nc_inq_varid(file, "time", &id));
  need(nc_get_att_text(file, id, "units", text));
  assert_int_equal(strncmp(text, "seconds since 2000-01-01 00:00:00", 33), 0);
  double clock[3];
  need(nc_get_var_double(file, id, clock)); /* TAI noon of 2000 is 32 s earlier by UTC */
  assert_true(fabs(clock[1] - (43200.0 - 32.0 + 1.0)) < 1e-6);
  need(nc_inq_varid(file, "irradiance", &id));
  double light[4 * 3 * 2];
  need(nc_get_var_double(file, id, light));
  for (size_t i = 0; i < 4; i++)
    for (size_t k = 0; k < 3; k++)
      for (size_t b = 0; b < 2; b++) {
        double expected = value[i * 9 + b * 3 + k], got = light[(i * 3 + k) * 2 + b];
        assert_true(got == expected || (isnan(got) && isnan(expected)));
      }
  need(nc_inq_varid(file, "temperature_nominal", &id));
  double warm[3];
  need(nc_get_var_double(file, id, warm));
  assert_true(warm[2] == 108.0);
  need(nc_inq_varid(file, "irradiance_error", &id));
  need(nc_get_var_double(file, id, light));
  assert_true(light[1] == 2e-3);
  need(nc_inq_varid(file, "irradiance_error_asked", &id));
  need(nc_get_var_double(file, id, light));
  assert_true(light[1] == 1e-3);
  memset(text, 0, sizeof text);
  need(nc_get_att_text(file, NC_GLOBAL, "falls_short", text));
  assert_string_equal(text,
                      "irradiance:lwir: error at most 0.002, 2 times the 0.001 that is asked");
  need(nc_inq_varid(file, "reason", &id));
  char *words[4];
  need(nc_get_var_string(file, id, words));
  assert_string_equal(words[1], "dark");
  assert_string_equal(words[2], "");
  need(nc_free_string(4, words));
  need(nc_inq_varid(file, "band", &id));
  need(nc_get_var_string(file, id, words));
  assert_string_equal(words[1], "lwir");
  need(nc_free_string(2, words));
  need(nc_close(file));
  remove(PATH);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_read_back)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
