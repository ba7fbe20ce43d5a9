/* umbra sensitivity: its files say the same thing, a what-if is answered, and what is wrong is said
 * before anything is written. */
#include <math.h>
#include <netcdf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

#define BOX "sensitivity", "box.yaml", "--set", "time.step_s=30"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

static size_t length(int file, const char *dimension)
{
  int id;
  size_t n;
  assert_int_equal(nc_inq_dimid(file, dimension, &id), NC_NOERR);
  assert_int_equal(nc_inq_dimlen(file, id, &n), NC_NOERR);
  return n;
}

/* The place of a name on its axis. */
static size_t place_of(int file, const char *axis, const char *name)
{
  int id;
  size_t n = length(file, axis), found = n;
  char **text = malloc(n * sizeof *text);
  assert_int_equal(nc_inq_varid(file, axis, &id), NC_NOERR);
  assert_int_equal(nc_get_var_string(file, id, text), NC_NOERR);
  for (size_t i = 0; i < n; i++)
    if (strcmp(text[i], name) == 0) found = i;
  nc_free_string(n, text);
  free(text);
  if (found == n) fail_msg("%s has no '%s'", axis, name);
  return found;
}

/* The largest derivative of a band by a parameter. */
static double largest(int file, const char *parameter, const char *band)
{
  int id;
  size_t n = length(file, "time");
  double *value = malloc(n * sizeof *value), most = 0.0;
  const size_t from[] = {place_of(file, "parameter", parameter), place_of(file, "band", band), 0};
  const size_t count[] = {1, 1, n};
  assert_int_equal(nc_inq_varid(file, "d_light", &id), NC_NOERR);
  assert_int_equal(nc_get_vara_double(file, id, from, count, value), NC_NOERR);
  for (size_t k = 0; k < n; k++) most = fmax(most, fabs(value[k])); /* NaN is left out */
  free(value);
  return most;
}

/* parameters.csv gives that derivative times the width, in percent of the largest light. */
static void test_files(void **state)
{
  (void)state;
  int file, id;
  command_expect(0, BOX, "--only", "emittance", "--only", "zero_point:lwir", "--no-plots", "--out",
                 "found", "--elasticity", "--what-if", "emittance:grey_white,factor=0.99", NULL);
  struct table t = table_read("found/parameters.csv");
  assert_int_equal(nc_open("found/sensitivity.nc", NC_NOWRITE, &file), NC_NOERR);
  size_t n = length(file, "time"), bands = length(file, "band");
  double *light = malloc(n * bands * sizeof *light), peak = 0.0;
  size_t lwir = place_of(file, "band", "lwir"), row = t.nrow;
  assert_int_equal(nc_inq_varid(file, "light", &id), NC_NOERR);
  assert_int_equal(nc_get_var_double(file, id, light), NC_NOERR);
  for (size_t k = 0; k < n; k++) peak = fmax(peak, light[lwir * n + k]);
  for (size_t i = 0; i < t.nrow; i++)
    if (strcmp(table_text(&t, i, "parameter"), "emittance:grey_white.factor") == 0) row = i;
  assert_true(row < t.nrow);
  double expected = 100.0 * largest(file, "emittance:grey_white.factor", "lwir") *
                    table_number(&t, row, "width") / peak;
  assert_true(expected > 0.1);
  assert_close(table_number(&t, row, "lwir_percent_per_width"), expected, 1e-6 * expected);
  /* a factor: a hundredth of it is a hundredth of what it scales */
  assert_close(table_number(&t, row, "lwir_percent_per_percent"),
               0.01 * expected / table_number(&t, row, "width"), 1e-6 * expected);
  assert_int_equal(nc_inq_varid(file, "elasticity_light", &id), NC_NOERR);
  nc_close(file);
  table_release(&t);
  t = table_read("found/what_if.csv");
  for (size_t i = 0; i < t.nrow; i++)
    assert_close(table_number(&t, i, "linear"), table_number(&t, i, "true"),
                 1e-3 * table_number(&t, i, "true"));
  table_release(&t);
  free(light);
}

static void test_refused(void **state)
{
  (void)state;
  command_expect(1, BOX, "--only", "emittanse", NULL);
  command_expect(1, BOX, "--what-if", "emittance:grey_white,emittance_facto=1", NULL);
  command_expect(1, BOX, "--only", "zero_point", "--no-plots", "--what-if",
                 "emittance:grey_white,factor=1.1", NULL);
  command_expect(2, "sensitivity", NULL);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_files, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
