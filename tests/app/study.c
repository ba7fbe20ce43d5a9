/* umbra study at the command: killed at random moments and resumed, on a full disk, with a point
 * that the scenario refuses, with measurements. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "base/core/sampling.h"
#include "tests/app/command.h"
#include "tests/app/table.h"
#include "tests/support/whole.h"

#define POINTS 12

static const char study[] =
    "schema: 1\n"
    "name: kills\n"
    "scenario: box.yaml\n"
    "parameters:\n"
    "  - {material: grey_white, property: emittance, from: 0.7, to: 0.9}\n"
    "  - {key: parts.bus.shell.areal_heat_capacity_J_m2_K, from: 2000, to: 4000, unit: J/m2/K}\n"
    "design: {kind: latin_hypercube, points: 12, seed: 1}\n"
    "outputs: {bands: [vis, lwir], places: [bus]}\n";

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  /* instants enough that records are longer than the list of what they are made of */
  char *box = command_edit(command_data("box.yaml"), "step_s: 60}", "step_s: 5}");
  command_write("box.yaml", box);
  free(box);
  command_write("study.yaml", study);
  return 0;
}

static long size_of(const char *path)
{
  struct stat st;
  return stat(path, &st) == 0 ? (long)st.st_size : 0;
}

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void expect_same(const char *a, const char *b)
{
  static const char *const files[] = {"study.nc", "points.csv", NULL};
  command_expect_same(a, b, files);
}

/* Records of a half of the points, as long as they are when each is there once. */
static long records_of_half(void)
{
  command_expect(0, "study", "study.yaml", "-o", "half", "--share", "1/2", NULL);
  long size = size_of("half.points/points-1-of-2.records");
  assert_true(size > POINTS / 2 * 8);
  return size;
}

/* Five times SIGKILL (twenty in the whole sweep), each later begun again where it was: records only
 * grow, but for one that was being written, and hold no point twice; the result is that of a study
 * that nobody killed. */
static void test_kills(void **state)
{
  (void)state;
  static const char records[] = "killed.points/points-1-of-2.records";
  static const char *const half[] = {"study", "study.yaml", "-o",        "killed", "--share",
                                     "1/2",   "--resume",   "--workers", "2",      NULL};
  const int nkill = um_test_number(20, 5);
  long whole = records_of_half(), one = whole / (POINTS / 2);
  double begin = now();
  command_expect(0, "study", "study.yaml", "-o", "whole", "--workers", "1", NULL);
  double took = now() - begin;
  int kills = 0, rounds = 0;
  long before = 0;
  for (int i = 0; kills < nkill && i < 20 * nkill; i++) {
    double after = 0.5 * took * um_core_hash_uniform(um_core_hash(11, (uint64_t)i));
    struct command c = command_run_for(after, SIGKILL, half);
    if (c.code != 0 && c.code != 128 + SIGKILL)
      fail_msg("kill %d: exit %d, it said:\n%s%s", i, c.code, c.out, c.err);
    long size = size_of(records);
    if (size > whole) fail_msg("kill %d: %ld bytes on record, all are %ld", i, size, whole);
    if (size < before - one) fail_msg("kill %d: records shrank from %ld to %ld", i, before, size);
    before = size;
    kills += c.code != 0;
    if (c.code == 0) { /* all of the half: begin anew */
      assert_int_equal(size, whole);
      if (kills < nkill) {
        assert_int_equal(remove(records), 0);
        before = 0;
        rounds++;
      }
    }
    command_release(&c);
  }
  print_message("%d kills in %d rounds of a study of %.2f s\n", kills, rounds + 1, took);
  assert_int_equal(kills, nkill);
  command_expect(0, "study", "study.yaml", "-o", "killed", "--share", "1/2", "--resume", NULL);
  assert_int_equal(size_of(records), whole);
  command_expect(0, "study", "study.yaml", "-o", "killed", "--share", "2/2", NULL);
  command_expect(0, "study", "study.yaml", "-o", "killed", "--resume", NULL);
  assert_false(command_exists("killed.points"));
  expect_same("whole", "killed");
}

/* No room for the records, then for the results: one line says so, what was computed is kept, and
 * the study goes on where there is room. */
static void test_full(void **state)
{
  (void)state;
  command_expect(0, "study", "study.yaml", "-o", "whole", NULL);
  long records = 2 * records_of_half();
  const long limits[2] = {records / 2, records + records / 4};
  for (int i = 0; i < 2; i++) {
    command_limit_files(limits[i]);
    struct command c = i == 0 ? command_run("study", "study.yaml", "-o", "full", NULL)
                              : command_run("study", "study.yaml", "-o", "full", "--resume", NULL);
    command_limit_files(0);
    assert_int_equal(c.code, 1);
    if (strstr(c.err, i == 0 ? "points.records" : "study.nc") == NULL ||
        strstr(c.err, "File too large") == NULL)
      fail_msg("limit %d: it said: %s", i, c.err);
    assert_int_equal(i == 1, strstr(c.err, "stay on record in full.points: --resume") != NULL);
    assert_false(command_exists("full"));
    assert_true(size_of("full.points/points.records") > records / 4);
    command_release(&c);
  }
  command_expect(0, "study", "study.yaml", "-o", "full", "--resume", NULL);
  expect_same("whole", "full");
}

/* A point that the scenario refuses is named with its reason; the others are there. */
static void test_refused_point(void **state)
{
  (void)state;
  command_write("refused.yaml", "schema: 1\nname: refused\nscenario: box.yaml\n"
                                "parameters: [{key: optics.samples, values: [4, 6.5, 9]}]\n"
                                "design: {kind: grid}\noutputs: {bands: [lwir]}\n");
  struct command c = command_run("study", "refused.yaml", "-o", "refused", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "1 could not be computed (points.csv says why)"));
  command_release(&c);
  char *points = command_read("refused/points.csv");
  assert_int_equal(command_count_lines(points), 4);
  assert_non_null(strstr(points, "\n0,4,"));
  assert_non_null(strstr(points, "\n1,6.5,,,,\"'--set: optics.samples: '6.5' is not accepted"));
  assert_non_null(strstr(points, "\n2,9,"));
  free(points);
}

/* A surrogate that does not reach what is asked is a result with warnings: stated beside asked. */
static void test_short(void **state)
{
  (void)state;
  command_write(
      "short.yaml",
      "schema: 1\nname: short\nscenario: box.yaml\nmode: surrogate\nevaluations: 40\n"
      "parameters:\n"
      "  - {effect: attitude_offset, parameter: z_deg, from: -40, to: 40}\n"
      "  - {key: parts.bus.box.size_m.0, from: 0.7, to: 1.3}\n"
      "error: {light: 1e-5, temperature_K: 0.001}\noutputs: {bands: [vis], places: [bus]}\n");
  struct command c = command_run("study", "short.yaml", "-o", "short", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  assert_non_null(strstr(c.err, "not smooth enough for a surrogate"));
  assert_non_null(strstr(c.err, "times the 0.001 that is asked"));
  assert_non_null(strstr(c.out, ", asked 0.001 K"));
  command_release(&c);
  char *table = command_read("short/table.md");
  assert_non_null(strstr(table, "times the 0.001 that is asked"));
  free(table);
  struct table t = table_read("short/summary.csv");
  assert_true(table_number(&t, 2, "error") > table_number(&t, 2, "error_asked"));
  table_release(&t);
  assert_false(command_exists("short.points"));
}

/* Measurements that the study names: every point's chi-square against them is kept, least near what
 * they were made of; a file that is not there is refused at its line before anything is computed.
 */
static void test_measured(void **state)
{
  (void)state;
  char *text = NULL, *more = malloc(sizeof study + 200);
  assert_non_null(more);
  strcpy(more, study);
  text = command_edit(more, "places: [bus]", "places: [bus], measured: pass.csv");
  command_write("measured.yaml", text);
  free(text);
  struct command c = command_run("study", "measured.yaml", "-o", "m", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "measured.yaml:8: outputs.measured: pass.csv: No such file"));
  command_release(&c);
  command_expect(0, "synth", "box.yaml", "--noise", "0.01", "--seed", "3", "-o", "pass.csv", NULL);
  command_expect(0, "study", "measured.yaml", "-o", "m", NULL);
  struct table t = table_read("m/points.csv");
  assert_int_equal(t.nrow, 12);
  size_t best = 0;
  for (size_t i = 1; i < t.nrow; i++)
    if (table_number(&t, i, "chi2_reduced:irradiance:lwir") <
        table_number(&t, best, "chi2_reduced:irradiance:lwir"))
      best = i;
  assert_true(table_number(&t, best, "rms:irradiance:lwir") > 0.0);
  assert_close(table_number(&t, best, "parts.bus.shell.areal_heat_capacity_J_m2_K"), 3000.0, 300.0);
  assert_true(command_exists("m/measured.csv") && command_exists("m/parameters.csv"));
  table_release(&t);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, command_leave)
  const struct CMUnitTest tests[] = {TEST(test_kills), TEST(test_full), TEST(test_refused_point),
                                     TEST(test_short), TEST(test_measured)};
  return cmocka_run_group_tests_name("study", tests, NULL, NULL);
}
