/* No table that a verb writes holds inf or nan: what is no number is an empty field. Scenarios and
 * measurements in which such values arise: light of a satellite in the dark that reflects nothing
 * and so has no magnitude, one below the horizon, one behind the Earth, a channel of one row, a
 * constant one, a parameter without a prior, candidates that are refused. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

/* A whole word, so that "minutes" and "infrared" may stand in a text. */
static const char *find_word(const char *text, const char *word)
{
  size_t n = strlen(word);
  for (const char *at = text; *at != '\0'; at++) {
    size_t i = 0;
    while (i < n && tolower((unsigned char)at[i]) == word[i]) i++;
    bool begins = at == text || !isalnum((unsigned char)at[-1]);
    if (i == n && begins && !isalnum((unsigned char)at[n])) return at;
  }
  return NULL;
}

static void expect_numbers(const char *path)
{
  static const char *const words[] = {"inf", "infinity", "nan"};
  char *text = command_read(path);
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    const char *at = find_word(text, words[i]);
    if (at != NULL) fail_msg("%s: %s in '%.60s'", path, words[i], at > text + 40 ? at - 40 : text);
  }
  free(text);
}

/* Every CSV below a folder; returns their number. */
static size_t expect_folder(const char *folder)
{
  char *snapshot = command_snapshot(folder);
  size_t n = 0;
  for (char *line = strtok(snapshot, "\n"); line != NULL; line = strtok(NULL, "\n")) {
    char path[512];
    snprintf(path, sizeof path, "%.*s", (int)strcspn(line, " "), line);
    size_t length = strlen(path);
    if (length < 4 || strcmp(path + length - 4, ".csv") != 0) continue;
    expect_numbers(path);
    n++;
  }
  free(snapshot);
  return n;
}

#define RUN(out, ...)                                                                              \
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", out, __VA_ARGS__, NULL)

/* In the umbra without any light but starlight nothing of a cold box is seen in the visible: its 4
 * bins at 3 K underflow to 0, and a flux of 0 has no magnitude. */
static void test_runs(void **state)
{
  (void)state;
  RUN("plain", "--threads", "1");
  RUN("dark", "--without", "earthshine", "--without", "earth_ir", "--without", "reflected_earth_ir",
      "--without", "albedo", "--without", "moonlight", "--without", "umbra_scatter", "--set",
      "thermal.start_temperature_K=4", "--set", "time.stop_utc=2016-09-06T18:09:00Z", "--set",
      "parts.bus.shell.areal_heat_capacity_J_m2_K=1e7");
  RUN("behind", "--set", "observer={direction: {unit_gcrs: [0, 0, -1], range_km: 20000}}");
  RUN("points", "--set", "observer={trajectory: {table: far.csv}}", "--set", "time.step_s=120");
  static const char *const folders[] = {"plain", "dark", "behind", "points"};
  for (size_t i = 0; i < 4; i++) assert_int_equal(expect_folder(folders[i]), 4);
  struct table t = table_read("dark/lightcurve.csv");
  size_t empty = 0;
  for (size_t k = 0; k < t.nrow; k++) {
    if (table_number(&t, k, "elevation_deg") < 0.0) continue;
    assert_true(table_number(&t, k, "vis_irradiance_W_m2") == 0.0);
    assert_string_equal(table_text(&t, k, "vis_mag_ab"), "");
    empty++;
  }
  assert_true(empty > 0);
  table_release(&t);
}

#define T(minute) "2016-09-06T18:" minute ":00Z"
#define HEAD      "time_utc,quantity,of,value,sigma\n"

static void test_comparisons(void **state)
{
  (void)state;
  command_write("one.csv", HEAD T("09") ",band_irradiance,vis,0,1e-12\n" T(
                               "09") ",temperature,bus,280,1\n" T("10") ",temperature,bus,280,1\n");
  command_expect(0, "compare", "box.yaml", "one.csv", "--no-plots", "--out", "one", NULL);
  assert_int_equal(expect_folder("one"), 2);
  command_write("dark.csv", HEAD T("08") ",magnitude_ab,vis,12,0.1\n" T(
                                "09") ",magnitude_ab,vis,12,0.1\n" T("10") ",magnitude_ab,vis,12,"
                                                                           "0.1\n");
  command_expect(0, "compare", "box.yaml", "dark.csv", "--without", "earthshine", "--no-plots",
                 "--out", "two", NULL);
  assert_int_equal(expect_folder("two"), 2);
  command_expect(0, "synth", "box.yaml", "--set", "time.step_s=6", "--set",
                 "time.start_utc=2016-09-06T18:08:00Z", "--noise", "0.01,0.001", "--seed", "5",
                 "-o", "m.csv", NULL);
  command_expect(0, "diagnose", "box.yaml", "m.csv", "--no-plots", "--out", "three", "--only",
                 "background", "--only", "panel_extraction", "--only", "zero_point", NULL);
  assert_true(expect_folder("three") >= 2);
  command_expect(0, "period", "m.csv", "--no-plots", "--out", "four", NULL);
  assert_int_equal(expect_folder("four"), 2);
}

static int enter_far(void **state)
{
  if (enter(state) != 0) return -1;
  /* someone 40 000 km away on the far side of the Earth from a pass over Austria */
  command_write("far.csv", "time_utc,x_km,y_km,z_km\n2016-09-06T18:00:00Z,0,0,-40000\n"
                           "2016-09-06T18:20:00Z,100,0,-40000\n");
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_runs, enter_far, command_leave),
      cmocka_unit_test_setup_teardown(test_comparisons, enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
