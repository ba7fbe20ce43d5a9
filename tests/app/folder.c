/* The output folder: it appears whole, replaces only what Umbra wrote, and a run that fails leaves
 * everything as it was. */
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "tests/app/command.h"

#define RUN "run", "box.yaml", "--no-plots"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

/* Names alone, without sizes and hashes. */
static void expect_names(const char *folder, const char *expected)
{
  char *snapshot = command_snapshot(folder), *names = calloc(strlen(snapshot) + 1, 1);
  assert_non_null(names);
  for (char *line = strtok(snapshot, "\n"); line != NULL; line = strtok(NULL, "\n")) {
    strncat(names, line, strcspn(line, " "));
    strcat(names, "\n");
  }
  assert_string_equal(names, expected);
  free(names);
  free(snapshot);
}

#define FILES(folder)                                                                              \
  folder "/.umbra\n" folder "/heat.csv\n" folder "/lightcurve.csv\n" folder "/log.txt\n" folder    \
         "/materials.csv\n" folder "/replay.json\n" folder "/report.html\n" folder                 \
         "/run.nc\n" folder "/run.xdmf\n" folder "/scenario.yaml\n" folder                         \
         "/temperatures.cic\n" folder "/temperatures.csv\n"

/* Everything that a run writes; nothing beside the folder. */
static void test_appears_whole(void **state)
{
  (void)state;
  command_expect(0, RUN, "--out", "a/b/out/", NULL);
  expect_names(".", "./\n./a/\n./a/b/\n./a/b/out/\n" FILES("./a/b/out") "./box.yaml\n");
}

/* Without --out the scenario's name stands under out/. */
static void test_default_place(void **state)
{
  (void)state;
  command_expect(0, RUN, NULL);
  expect_names(".", "./\n./box.yaml\n./out/\n./out/box/\n" FILES("./out/box"));
}

/* A variant made on the command line does not replace its base, nor another variant. */
static void test_variants_have_places(void **state)
{
  (void)state;
  command_expect(0, RUN, NULL);
  char *base = command_snapshot("out/box");
  struct command c = command_run(RUN, "--set", "time.step_s=120", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "results in out/box--set-time.step_s=120\n"
                                "to look at: out/box--set-time.step_s=120/report.html\n"));
  command_release(&c);
  command_expect(0, RUN, "--without", "albedo", "--with", "zero_point:vis,factor=0.5", NULL);
  command_expect(0, RUN, "--with", "zero_point:lwir,factor=0.5", NULL);
  command_expect(0, RUN, "--with", "zero_point,factor=0.5", "--set", "summary=a/../../../b", NULL);
  char *after = command_snapshot("out/box");
  assert_string_equal(after, base);
  size_t variants = 0;
  DIR *out = opendir("out");
  assert_non_null(out);
  for (struct dirent *entry = readdir(out); entry != NULL; entry = readdir(out))
    variants += strncmp(entry->d_name, "box--", 5) == 0;
  closedir(out);
  assert_int_equal(variants, 4);
  /* longer than any file name: cut, with a hash that tells two of one beginning apart */
  char text[2][400];
  for (int i = 0; i < 2; i++) {
    snprintf(text[i], sizeof text[i], "summary=%0300d", i);
    command_expect(0, RUN, "--set", text[i], NULL);
  }
  variants = 0;
  out = opendir("out");
  for (struct dirent *entry = readdir(out); entry != NULL; entry = readdir(out))
    variants += strncmp(entry->d_name, "box--set-summary", 16) == 0;
  closedir(out);
  assert_int_equal(variants, 3);
  free(base);
  free(after);
}

static void test_is_replaced(void **state)
{
  (void)state;
  command_expect(0, RUN, "--out", "out", NULL);
  command_write("out/stray", "left by someone in a folder of Umbra's\n");
  char *before = command_read("out/lightcurve.csv");
  command_expect(0, RUN, "--out", "out", "--set", "time.step_s=120", NULL);
  char *after = command_read("out/lightcurve.csv");
  assert_int_equal(command_count_lines(before), 1 + 5);
  assert_int_equal(command_count_lines(after), 1 + 3);
  expect_names(".", "./\n./box.yaml\n./out/\n" FILES("./out"));
  free(before);
  free(after);
}

static void expect_refused(const char *out, const char *says)
{
  char *before = command_snapshot(".");
  struct command c = command_run(RUN, "--out", out, NULL);
  char *after = command_snapshot(".");
  if (c.code != 1 || command_count_lines(c.err) != 1 || strstr(c.err, says) == NULL)
    fail_msg("--out %s: exit %d, expected '%s':\n%s", out, c.code, says, c.err);
  assert_string_equal(after, before);
  command_release(&c);
  free(before);
  free(after);
}

static void test_foreign_is_refused(void **state)
{
  (void)state;
  assert_int_equal(mkdir("mine", 0777), 0);
  command_write("mine/thesis.tex", "years of work\n");
  expect_refused("mine", "mine: exists and was not written by Umbra; accepted: ");
  expect_refused("box.yaml", "box.yaml: exists and is not a folder");
  expect_refused("box.yaml/out", "box.yaml");
  expect_refused(".", "cannot be an output folder");
  expect_refused("", "cannot be an output folder");
  command_expect(0, RUN, "--out", "mine", "--force", NULL);
  expect_names(".", "./\n./box.yaml\n./mine/\n" FILES("./mine"));
}

/* Runs that fail before, during and at the end of the work. */
static void test_failure_leaves_results(void **state)
{
  (void)state;
  command_expect(0, RUN, "--out", "out", NULL);
  command_write("q.csv", "time_utc,q0,q1,q2,q3\n2016-09-06T18:00:00Z,1,0,0,0\n"
                         "2016-09-06T18:05:00Z,1,0,0,0\n");
  char *before = command_snapshot(".");
  command_expect(1, RUN, "--out", "out", "--set", "time.step_s=0", NULL);
  command_expect(1, RUN, "--out", "out", "--set", "attitude=[{table: q.csv}]", NULL);
  command_limit_files(6000); /* less than run.nc, more than the tables */
  struct command c = command_run(RUN, "--out", "out", NULL);
  assert_int_equal(c.code, 1);
  if (command_count_lines(c.err) != 1 || strstr(c.err, "run.nc: ") == NULL)
    fail_msg("a full disk at run.nc:\n%s", c.err);
  command_release(&c);
  command_limit_files(300); /* less than lightcurve.csv */
  c = command_run(RUN, "--out", "out", NULL);
  assert_int_equal(c.code, 1);
  if (command_count_lines(c.err) != 1 || strstr(c.err, "lightcurve.csv: cannot be written") == NULL)
    fail_msg("a full disk at lightcurve.csv:\n%s", c.err);
  command_release(&c);
  command_limit_files(20); /* less than the marker */
  command_expect(1, RUN, "--out", "other", NULL);
  command_limit_files(0);
  char *after = command_snapshot(".");
  assert_string_equal(after, before);
  free(before);
  free(after);
}

/* A run of 24001 instants takes seconds; it is asked to end as soon as its folder is begun. */
static void test_interrupt_leaves_results(void **state)
{
  (void)state;
  static const int signals[] = {SIGINT, SIGTERM};
  static const char *const arguments[] = {RUN, "--out", "out", "--set", "time.step_s=0.01", NULL};
  command_expect(0, RUN, "--out", "out", NULL);
  char *before = command_snapshot(".");
  for (int i = 0; i < 2; i++) {
    struct command c = command_run_until(".out.partial", signals[i], arguments);
    if (c.code != 128 + signals[i] || strncmp(c.err, "umbra: cancelled while ", 23) != 0 ||
        command_count_lines(c.err) != 1)
      fail_msg("exit %d, said:\n%s", c.code, c.err);
    char *after = command_snapshot(".");
    assert_string_equal(after, before);
    free(after);
    command_release(&c);
  }
  free(before);
}

/* The copy of the scenario holds the changes of the command line and can be run again. */
static void test_scenario_copy(void **state)
{
  (void)state;
  command_expect(0, RUN, "--out", "a", "--set", "time.step_s=120", "--set",
                 "parts.bus.outside=black", NULL);
  command_expect(0, "run", "a/scenario.yaml", "--no-plots", "--out", "b", NULL);
  static const char *const names[] = {"lightcurve.csv", "temperatures.csv", "heat.csv"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    char path[2][64];
    snprintf(path[0], sizeof path[0], "a/%s", names[i]);
    snprintf(path[1], sizeof path[1], "b/%s", names[i]);
    char *a = command_read(path[0]), *b = command_read(path[1]);
    assert_string_equal(a, b);
    free(a);
    free(b);
  }
}

/* A scenario whose mesh, record and table stand in folders about it, with a sensor and a material
 * that come with the program. */
static void write_scene(void)
{
  static const char mesh[] = "v -1 -0.5 0\nv 1 -0.5 0\nv 1 0.5 0\nv -1 0.5 0\nf 1 2 3 4\n";
  char *text = command_data("box.yaml");
  text = command_edit(text, "parts:\n",
                      "parts: # two\n  - name: panel\n"
                      "    mesh: {file: meshes/panel.obj}\n"
                      "    front: own\n    back: grey_panel\n"
                      "    pose: {position_m: [0, 0, 1]}\n"
                      "    shell: {areal_heat_capacity_J_m2_K: 2000}\n"
                      "    lumped: true\n");
  text =
      command_edit(text, "    outside: grey_white\n",
                   "    outside: grey_white\n"
                   "    interior: {capacity_J_K: 900, conductance_W_K: 1, power_file: ../p.csv}\n");
  text = command_edit(text, "bands:", "material_files: ['../own record.yaml']\nbands:");
  assert_int_equal(mkdir("project", 0777), 0);
  assert_int_equal(mkdir("project/scene", 0777), 0);
  assert_int_equal(mkdir("project/scene/meshes", 0777), 0);
  command_write("project/scene/scenario.yaml", text);
  command_write("project/scene/meshes/panel.obj", mesh);
  command_write("project/own record.yaml",
                "name: own\nsummary: a paint\ncitation: none\ngrey: {solar_absorptance: 0.3, "
                "emittance: 0.8, vis_reflectance_diffuse: 0.7}\n");
  command_write("project/p.csv", "time_utc,power_W\n2016-09-06T10:00:00Z,20\n"
                                 "2016-09-06T20:00:00Z,40\n");
  free(text);
}

/* An effect on what is called as YAML's null is. */
static void test_scenario_names_null(void **state)
{
  (void)state;
  static const char *const files[] = {"lightcurve.csv", NULL};
  char *text = command_edit(command_data("box.yaml"), "  lwir:", "  \"null\":");
  command_write("null.yaml", text);
  free(text);
  command_expect(0, "run", "null.yaml", "--no-plots", "--out", "one", "--with",
                 "zero_point:null,factor=1.1", NULL);
  command_expect(0, "run", "one", "--no-plots", "--out", "two", NULL);
  command_expect_same("one", "two", files);
}

/* A run's scenario.yaml stands where its results are: run from there it gives their bytes, with all
 * that the command line changed; also when the folders moved together. */
static void test_scenario_runs_where_it_stands(void **state)
{
  (void)state;
  static const char *const files[] = {"lightcurve.csv", "materials.csv", "temperatures.csv",
                                      "heat.csv", NULL};
  write_scene();
  command_expect(0, "export", "project/scene", "--as", "exchange", "--out", "project/seen", NULL);
  command_expect(
      0, "run", "project/scene", "--no-plots", "--out", "project/a/b", "--set",
      "parts.bus.interior.capacity_J_K=1200", "--set",
      "thermal={start: isothermal, orbits_before: 0.05, step_s: 30, view_factors: ../seen}",
      "--set", "parts.panel.shell.areal_heat_capacity_J_m2_K=2500", "--set",
      "sensors.ufo={preset: ufo, band: vis, exposure_s: 1}", "--with",
      "internal_power:bus,power_W=15", "--with", "zero_point:lwir,factor=1.1", "--without",
      "albedo", NULL);
  char *text = command_read("project/a/b/scenario.yaml");
  assert_non_null(strstr(text, "view_factors: ../../seen"));
  assert_non_null(strstr(text, "file: ../../scene/meshes/panel.obj"));
  assert_non_null(strstr(text, "\"../../own record.yaml\""));
  free(text);
  command_expect(0, "run", "project/a/b/scenario.yaml", "--no-plots", "--out", "again", NULL);
  command_expect_same("project/a/b", "again", files);
  assert_true(command_exists("again/counts.csv"));
  assert_int_equal(rename("project", "elsewhere"), 0);
  command_expect(0, "run", "elsewhere/a/b", "--no-plots", "--out", "moved", NULL);
  command_expect_same("again", "moved", files);
  /* and its own own */
  command_expect(0, "run", "moved", "--no-plots", "--out", "elsewhere/last", NULL);
  command_expect_same("moved", "elsewhere/last", files);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_appears_whole, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_default_place, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_variants_have_places, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_is_replaced, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_foreign_is_refused, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_failure_leaves_results, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_interrupt_leaves_results, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_scenario_copy, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_scenario_runs_where_it_stands, command_enter,
                                      command_leave),
      cmocka_unit_test_setup_teardown(test_scenario_names_null, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
