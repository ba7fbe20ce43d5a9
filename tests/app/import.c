/* umbra import: from a table that every verb refuses, by the command that it names, to a
 * comparison.
 */
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"

#define TABLE                                                                                      \
  "UTC,V,Verr\n2016-09-06T18:09:30Z,9.5,0.05\n2016-09-06T18:10:00Z,9.25,0.04\n"                    \
  "2016-09-06T18:10:30Z,,0.1\n"

/* What the same rows are as the program's own file. */
#define OWN                                                                                        \
  "time_utc,quantity,of,value,sigma\n2016-09-06T18:09:30Z,magnitude_vega,vis,9.5,0.05\n"           \
  "2016-09-06T18:10:00Z,magnitude_vega,vis,9.25,0.04\n"

/* The refusal of each verb names a command; typed as it stands it makes a file. */
static void test_named_command(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_write("lc.csv", TABLE);
#define TYPE "umbra import lc.csv --time UTC --magnitude V --sigma Verr -o lc-measured.csv"
  static const struct failure failures[] = {
      {{"compare", "box.yaml", "lc.csv"},
       "lc.csv: header: no measurement file, but a table that can be made one: " TYPE},
      {{"diagnose", "box.yaml", "lc.csv"}, TYPE},
      {{"fit", "box.yaml", "lc.csv", "--add", "albedo_level"}, TYPE},
      {{"period", "lc.csv"}, TYPE},
      {{"map", "box.yaml", "lc.csv"}, TYPE},
      {{"import", "lc.csv", "-o", "m.csv"}, "lc.csv: which column is what? as it seems: " TYPE},
      {{"import", "lc.csv", "-o", "m.csv", "--time", "UTC", "--magnitude", "v_mag"},
       "lc.csv: no column 'v_mag'; the file has: UTC, V, Verr"},
      {{"import", "lc.csv", "-o", "m.csv", "--format", "mmt", "--time", "UTC"},
       "--format mmt: a track has its own columns"},
      {{"import", "lc.csv", "-o", "m.csv", "--format", "csv"}, "accepted: mmt, table"},
      {{"import", "box.yaml", "-o", "m.csv", "--like", "lc.csv"},
       "lc.csv: no line '# umbra import: ...' at its head"},
  };
  failures_expect(failures, sizeof failures / sizeof failures[0]);
  struct command c = command_run("import", "lc.csv", "--time", "UTC", "--magnitude", "V", "--sigma",
                                 "Verr", "-o", "lc-measured.csv", NULL);
  assert_int_equal(c.code, 0);
  assert_string_equal(c.out, "lc-measured.csv: 2 rows of magnitude_vega V, times read as UTC, 1 "
                             "value that is not there left out\n");
  command_release(&c);
}

/* A comparison with the imported file has the bytes of one with the same rows in the program's own
 * form; --like does the same again. */
static void test_round_trip(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_write("lc.csv", TABLE);
  command_write("own.csv", OWN);
  command_expect(0, "import", "lc.csv", "--time", "UTC", "--magnitude", "V", "--sigma", "Verr",
                 "--band", "vis", "-o", "first.csv", NULL);
  command_expect(0, "import", "lc.csv", "--like", "first.csv", "-o", "second.csv", NULL);
  char *first = command_read("first.csv"), *second = command_read("second.csv");
  assert_string_equal(first, second);
  assert_memory_equal(
      first,
      "# umbra import: time=UTC magnitude=V band=vis system=vega sigma=Verr\ntime_utc,quantity,",
      80);
  free(first);
  free(second);
  command_expect(0, "compare", "box.yaml", "first.csv", "--no-plots", "--out", "imported", NULL);
  command_expect(0, "compare", "box.yaml", "own.csv", "--no-plots", "--out", "own", NULL);
  char *a = command_read("imported/residuals.csv"), *b = command_read("own/residuals.csv");
  assert_string_equal(a, b);
  assert_int_equal(command_count_lines(a), 3);
  free(a);
  free(b);
  /* what is said goes before --like; another kind of value leaves the like's words of it behind */
  command_expect(0, "import", "lc.csv", "--like", "first.csv", "--band", "lwir", "--system", "ab",
                 "-o", "third.csv", NULL);
  char *third = command_read("third.csv");
  assert_non_null(strstr(third, "magnitude_ab,lwir,9.5,0.05"));
  free(third);
  command_expect(0, "import", "lc.csv", "--like", "first.csv", "--temperature", "V", "--of", "bus",
                 "--unit", "C", "-o", "fourth.csv", NULL);
  third = command_read("fourth.csv");
  assert_non_null(strstr(third, "temperature,bus,282.65,0.05"));
  free(third);
  command_expect(1, "import", "lc.csv", "--like", "first.csv", "-o", "first.csv", NULL);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_named_command, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_round_trip, command_enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
