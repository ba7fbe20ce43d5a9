/* Input that is meant to do harm, or cannot have been meant at all: it costs no more time and
 * memory than its size is worth, runs nothing, and ends in one clear line. */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tests/app/command.h"
#include "tests/app/small.h"

#define BOX                                                                                        \
  "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n    outside: grey_white\n"                   \
  "    shell: {areal_heat_capacity_J_m2_K: 1000}\n    lumped: true\n"
#define SAFE "accepted: a name of at most 255 bytes without control characters"

/* Run, and expect one line that holds both words (or NULL). */
static void expect_refused(const char *const *arguments, const char *word, const char *other)
{
  struct command c = command_run_list(arguments);
  if (c.code != 1 || strstr(c.err, word) == NULL || (other != NULL && strstr(c.err, other) == NULL))
    fail_msg("exit %d, wanted '%s' and '%s'; it said:\n%s%s", c.code, word,
             other == NULL ? "" : other, c.out, c.err);
  assert_int_equal(command_count_lines(c.err), 1);
  command_release(&c);
}

/* Processor time of all commands so far [s]. */
static double worked(void)
{
  struct rusage used;
  assert_int_equal(getrusage(RUSAGE_CHILDREN, &used), 0);
  return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

static FILE *create(const char *path)
{
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  return file;
}

/* The library compared every key with every other: 8 s for 20,000 of them. */
static void test_many_keys(void **state)
{
  (void)state;
  FILE *file = create("s.yaml");
  fputs("schema: 1\n", file);
  for (int i = 0; i < 20000; i++) fprintf(file, "k%d: 1\n", i);
  fclose(file);
  double begin = worked();
  expect_refused((const char *[]){"check", "s.yaml", NULL}, "s.yaml:2: k0: unknown key 'k0'", NULL);
  assert_true(worked() - begin < 4.0);
  file = create("s.yaml");
  for (int i = 0; i < 300000; i++) fprintf(file, "k%d: 1\n", i);
  fclose(file);
  expect_refused((const char *[]){"check", "s.yaml", NULL}, "s.yaml: larger than the 2097152 bytes",
                 NULL);
  command_write("s.yaml", "schema: 1\nname: a\nsummary: x\nname: b\n");
  expect_refused((const char *[]){"check", "s.yaml", NULL},
                 "s.yaml:4: duplicate key 'name'; accepted: each key once", NULL);
}

/* Every part had room for the groups of all: 615 MB for 1000. */
static void test_many_parts(void **state)
{
  (void)state;
  FILE *file = create("s.yaml");
  fputs(SMALL_HEAD "parts:\n", file);
  for (int i = 0; i < 1000; i++)
    fprintf(file,
            "  - {name: p%d, box: {size_m: [1, 1, 1]}, outside: black, lumped: true, pose: "
            "{position_m: [%d, 0, 0]}, shell: {areal_heat_capacity_J_m2_K: 1000}%s%d%s}\n",
            i, 2 * (i > 0), i > 0 ? ", parent: p" : ", facet_size_m: ", i > 0 ? i - 1 : 2, "");
  fclose(file);
  struct command c = command_run("check", "s.yaml", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  printf("1000 parts, each on the one before: %ld MB\n", c.peak_kB / 1024);
#if !defined(__SANITIZE_ADDRESS__)
  assert_true(c.peak_kB < 150 * 1024);
#endif
  command_release(&c);
  file = create("s.yaml");
  fputs(SMALL_HEAD "parts:\n", file);
  for (int i = 0; i < 5001; i++) fprintf(file, "  - {name: p%d}\n", i);
  fclose(file);
  expect_refused((const char *[]){"check", "s.yaml", NULL}, "parts: 5001 elements",
                 "accepted: at most 5000");
}

/* A group was looked for among all before it: 17 s for 60,000. */
static void test_many_groups(void **state)
{
  (void)state;
  FILE *file = create("m.obj");
  for (int i = 0; i < 60000; i++)
    fprintf(file, "g q%d\nv %d %d 0\nv %d.9 %d 0\nv %d %d.9 0\nf -3 -2 -1\n", i, i % 300, i / 300,
            i % 300, i / 300, i % 300, i / 300);
  fclose(file);
  command_write("s.yaml",
                SMALL_HEAD "parts:\n  - name: b\n    mesh: m.obj\n    front: black\n"
                           "    back: black\n    shell: {areal_heat_capacity_J_m2_K: 1000}\n");
  double begin = worked();
  expect_refused((const char *[]){"check", "s.yaml", NULL},
                 "parts.b.mesh: m.obj: more than 2000 groups", "'q2000'");
  assert_true(worked() - begin < 4.0);
}

/* A scenario has no code of its own run. */
static void test_effect_files(void **state)
{
  (void)state;
  static const char refused[] = "effect_files: 'e.so' is code that would run inside the program";
  command_write("e.so", "not an object\n");
  command_write("s.yaml", SMALL_HEAD BOX "effect_files: [e.so]\n");
  static const char *const verbs[] = {"check", "run", "forecast"};
  for (size_t i = 0; i < 3; i++)
    expect_refused((const char *[]){verbs[i], "s.yaml", i == 2 ? "--times" : NULL, NULL}, refused,
                   "--allow-effects");
  expect_refused((const char *[]){"check", "s.yaml", "--effect-file", "s.yaml", NULL}, refused,
                 "--effect-file with that file");
  /* named on the command line, or allowed, it is loaded, and found to be none */
  expect_refused((const char *[]){"check", "s.yaml", "--effect-file", "./e.so", NULL},
                 "accepted: a shared object", NULL);
  expect_refused((const char *[]){"check", "s.yaml", "--allow-effects", NULL},
                 "accepted: a shared object", NULL);
}

/* Values of --set that hold line ends stand in the written scenario so that it is read again. */
static void test_set_is_read_again(void **state)
{
  (void)state;
  command_write("s.yaml", SMALL_HEAD BOX);
  static const char *const values[] = {"summary=white\n\nx",   "summary=a\rb",
                                       "summary=\"a\\x85b\"",  "summary=\"a\\u2028b\"",
                                       "summary=\"- : #\\t\"", "summary='it''s: #1'"};
  for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
    char folder[8];
    snprintf(folder, sizeof folder, "o%zu", i);
    command_expect(0, "run", "s.yaml", "--no-plots", "--out", folder, "--set", values[i], NULL);
    command_expect(0, "check", folder, NULL);
  }
  expect_refused((const char *[]){"check", "s.yaml", "--set",
                                  "parts.b.outside=whiteLLs=\r\reLLstop_utcLL=", NULL},
                 "--set: parts.b.outside", SAFE);
}

/* The turn of the body sets the grid of the loads, unless they are means over it. */
static void test_fast_spin(void **state)
{
  (void)state;
  char *text = strdup(SMALL_HEAD BOX);
  text = command_edit(text, "fixed: {q_gcrs: [1, 0, 0, 0]}",
                      "spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0, 1], period_s: 0.01}");
  command_write("s.yaml", text);
  expect_refused(
      (const char *[]){"run", "s.yaml", "--no-plots", "--set", "thermal.spin_loads=resolved", NULL},
      "s.yaml:6: attitude.0.spin.period_s: ", "accepted: up to 5e+06 of them");
  free(text);
}

/* A picture that would take hundreds of GB on the disk: refused before the heat is computed. */
static void test_large_picture(void **state)
{
  (void)state;
  command_write("s.yaml", SMALL_HEAD BOX);
  expect_refused((const char *[]){"render", "s.yaml", "--time", "2016-03-20T04:30:00Z", "--band",
                                  "vis", "-o", "x.exr", "--width", "8000", "--samples", "1",
                                  "--set", "bands.vis.bins=2000", NULL},
                 "x.exr: up to ", "a name in .nc, which keeps the picture factored");
  assert_false(command_exists("x.exr"));
}

static void test_measured_names(void **state)
{
  (void)state;
  static const char *const names[] = {
      "x`id`", "\"x\"\"; system(\"\"touch P\"\"); o = \"\"y\"", "x$(touch P)", "x\\y", "x\x01y",
      "x\x9b"};
  /* what a spreadsheet would run begins as a group's "+x" may; tables keep it from being run */
  static const char *const formulas[] = {"=cmd", "@x", "-2+3"};
  char text[512];
  command_write("s.yaml", SMALL_HEAD BOX);
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    snprintf(text, sizeof text,
             "time_utc,quantity,of,value,sigma\n2016-03-20T04:30:00Z,temperature,%s,300,1\n",
             names[i]);
    command_write("m.csv", text);
    expect_refused((const char *[]){"compare", "s.yaml", "m.csv", NULL}, "m.csv:2: column 'of'",
                   SAFE);
    expect_refused((const char *[]){"diagnose", "s.yaml", "m.csv", NULL}, "m.csv:2: column 'of'",
                   SAFE);
    expect_refused((const char *[]){"period", "m.csv", NULL}, "m.csv:2: column 'of'", SAFE);
    snprintf(
        text, sizeof text,
        "time_utc,quantity,of,value,sigma,track\n2016-03-20T04:30:00Z,temperature,b,300,1,%s\n",
        names[i]);
    command_write("m.csv", text);
    expect_refused((const char *[]){"compare", "s.yaml", "m.csv", NULL}, "m.csv:2: column 'track'",
                   SAFE);
  }
  for (size_t i = 0; i < sizeof formulas / sizeof formulas[0]; i++) {
    snprintf(text, sizeof text,
             "time_utc,quantity,of,value,sigma\n2016-03-20T04:30:00Z,temperature,%s,300,1\n",
             formulas[i]);
    command_write("m.csv", text);
    expect_refused((const char *[]){"compare", "s.yaml", "m.csv", NULL}, "m.csv:2: column 'of'",
                   "the scenario has no place");
    snprintf(
        text, sizeof text,
        "time_utc,quantity,of,value,sigma,track\n2016-03-20T04:30:00Z,temperature,b,300,1,%s\n",
        formulas[i]);
    command_write("m.csv", text);
    expect_refused((const char *[]){"compare", "s.yaml", "m.csv", NULL}, "m.csv:2: column 'track'",
                   "its first character none of = + - @");
  }
  assert_false(command_exists("P"));
}

static void test_survey_names(void **state)
{
  (void)state;
  command_write("t.txt", "# track: 1\n# Date Time Mag Filter\n2016-09-21 20:30:00 5.0 "
                         "V\";system(\"touch${IFS}P\");o=\"\n");
  expect_refused((const char *[]){"import", "t.txt", "-o", "m.csv", NULL},
                 "t.txt:3: column 'Filter'", SAFE);
  command_write("t.txt", "# track: `touch${IFS}P`\n# Date Time Mag Filter\n2016-09-21 20:30:00 5.0 "
                         "V\n");
  expect_refused((const char *[]){"import", "t.txt", "-o", "m.csv", NULL},
                 "t.txt:3: column 'Track'", SAFE);
  assert_false(command_exists("P") || command_exists("m.csv"));
}

/* Exit status of the program with some of its standard streams closed. */
static int run_closed(unsigned closed, const char *const *arguments)
{
  pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    for (int fd = 0; fd < 3; fd++)
      if (closed >> fd & 1u) close(fd);
    execv(UMBRA_PROGRAM, (char **)(size_t)arguments);
    _exit(127);
  }
  int state;
  assert_int_equal(waitpid(child, &state, 0), child);
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

/* A pipe or a file of ours on number 0, 1 or 2 would get what is printed. */
static void test_closed_streams(void **state)
{
  (void)state;
#ifdef UMBRA_TETGEN
  command_write("s.yaml", SMALL_HEAD "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n"
                                     "    outside: grey_white\n    solid: {density_kg_m3: 2700, "
                                     "specific_heat_J_kg_K: 900, conductivity_W_m_K: 150}\n");
#else
  command_write("s.yaml", SMALL_HEAD BOX);
#endif
  command_expect(0, "run", "s.yaml", "--no-plots", "--out", "whole", NULL);
  char *whole = command_read("whole/lightcurve.csv");
  for (unsigned closed = 1; closed < 8; closed++) {
    const char *const list[] = {"umbra", "run", "s.yaml",  "--no-plots",
                                "--out", "out", "--force", NULL};
    assert_int_equal(run_closed(closed, list), 0);
    char *text = command_read("out/lightcurve.csv");
    assert_string_equal(text, whole);
    free(text);
  }
  free(whole);
}

#ifdef UMBRA_TETGEN
/* TetGen, far from done, dies with the program that started it. */
static void test_no_orphan(void **state)
{
  (void)state;
  char here[4096];
  const struct timespec pause = {0, 50000000};
  assert_non_null(getcwd(here, sizeof here));
  command_write("s.yaml", SMALL_HEAD "parts:\n  - name: b\n    box: {size_m: [1, 1, 1]}\n"
                                     "    facet_size_m: 0.03\n    outside: grey_white\n"
                                     "    solid: {density_kg_m3: 2700, specific_heat_J_kg_K: 900, "
                                     "conductivity_W_m_K: 150, tetrahedron_size_m: 0.01}\n");
  pid_t program = fork();
  assert_true(program >= 0);
  if (program == 0) {
    execl(UMBRA_PROGRAM, "umbra", "check", "s.yaml", (char *)NULL);
    _exit(127);
  }
  for (int i = 0; i < 400 && command_processes_below(here) < 2; i++) nanosleep(&pause, NULL);
  assert_int_equal(command_processes_below(here), 2);
  kill(program, SIGKILL);
  assert_int_equal(waitpid(program, NULL, 0), program);
  for (int i = 0; i < 20 && command_processes_below(here) > 0; i++) nanosleep(&pause, NULL);
  assert_int_equal(command_processes_below(here), 0);
}
#endif

#define TEST(name) cmocka_unit_test_setup_teardown(name, command_enter, command_leave)

int main(void)
{
  const struct CMUnitTest tests[] = {
      TEST(test_many_keys),      TEST(test_many_parts),        TEST(test_many_groups),
      TEST(test_effect_files),   TEST(test_set_is_read_again), TEST(test_fast_spin),
      TEST(test_large_picture),  TEST(test_measured_names),    TEST(test_survey_names),
      TEST(test_closed_streams),
#ifdef UMBRA_TETGEN
      TEST(test_no_orphan),
#endif
  };
  return cmocka_run_group_tests_name("hostile", tests, NULL, NULL);
}
