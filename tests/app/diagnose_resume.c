/* umbra diagnose and umbra fit that were ended: by a full disk after a while, by SIGKILL, by
 * SIGTERM. --resume ends with the files of one that was not, but for the time it took; with another
 * measurement file, another option or without --resume nothing is taken and nothing is lost. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"

#define BOX "box.yaml", "--set", "time.step_s=12", "--set", "time.start_utc=2016-09-06T18:08:00Z"
#define ASKED                                                                                      \
  "diagnose", BOX, "m.csv", "--no-plots", "--only", "emittance", "--only", "area:bus", "--only",   \
      "zero_point", "--only", "albedo_level", "--only", "solar_absorptance"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--temperatures", "bus", "--seed", "5",
                 "-o", "m.csv", "--with", "emittance:grey_white,factor=0.8", "--with",
                 "zero_point:vis,factor=0.9", NULL);
  return 0;
}

/* The file without what was typed and how long it took; how often a model was computed stays. */
static char *read_lines(const char *folder, const char *name)
{
  char path[80];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  char *text = command_read(path), *to = text;
  for (char *line = text, *end; *line != '\0'; line = end) {
    end = line + strcspn(line, "\n");
    end += *end == '\n';
    size_t n = (size_t)(end - line);
    char *typed = strstr(line, "umbra diagnose "), *took = strstr(line, "\"seconds\"");
    if (typed != NULL && typed < end) continue;
    if (took != NULL && took < end) n = (size_t)(took - line);
    memmove(to, line, n);
    to += n;
  }
  *to = '\0';
  return text;
}

static void expect_same(const char *a, const char *b)
{
  static const char *const files[] = {"diagnosis.json", "ranking.csv", "fit.csv",
                                      "improved/scenario.yaml"};
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    char *one = read_lines(a, files[i]), *other = read_lines(b, files[i]);
    assert_true(strlen(one) > 500);
    assert_string_equal(one, other);
    free(one);
    free(other);
  }
}

static void expect_resumed(const char *folder, const char *threads)
{
  char records[64];
  snprintf(records, sizeof records, "%s.records", folder);
  command_expect(0, ASKED, "-o", folder, "--resume", "--threads", threads, NULL);
  expect_same("whole", folder);
  assert_false(command_exists(records));
}

static void test_ended(void **state)
{
  (void)state;
  command_expect(0, ASKED, "-o", "whole", "--threads", "1", NULL);
  assert_false(command_exists("whole.records"));
  static const long limit[] = {9000, 25000, 45000}; /* of records [byte] */
  for (size_t i = 0; i < sizeof limit / sizeof *limit; i++) {
    char folder[16], says[160];
    snprintf(folder, sizeof folder, "full%zu", i);
    snprintf(says, sizeof says,
             "umbra: %s.records keeps what was computed, and --resume goes on from there: "
             "%s.records/points.records: ",
             folder, folder);
    command_limit_files(limit[i]);
    struct command c = command_run(ASKED, "-o", folder, "--threads", i % 2 == 0 ? "1" : "2", NULL);
    command_limit_files(0);
    assert_int_equal(c.code, 1);
    assert_false(command_exists(folder));
    if (strstr(c.err, says) == NULL) fail_msg("it said: %s", c.err);
    command_release(&c);
    expect_resumed(folder, i % 2 == 0 ? "2" : "1");
  }
  static const int signals[] = {SIGKILL, SIGTERM};
  const char *const asked[] = {ASKED, "-o", "ended", "--threads", "2", NULL};
  for (size_t i = 0; i < 2; i++) {
    struct command c = command_run_for(0.3 * (double)(i + 1), signals[i], asked);
    assert_true(c.code == 0 || c.code == 128 + signals[i]);
    command_release(&c);
    expect_resumed("ended", "2"); /* results of the one before are replaced */
  }
}

static void expect_refused(const char *const *arguments, const char *says)
{
  char *before = command_snapshot("o.records");
  struct command c = command_run_list(arguments);
  assert_int_equal(c.code, 1);
  if (strstr(c.err, says) == NULL) fail_msg("'%s' is not in: %s", says, c.err);
  assert_int_equal(command_count_lines(c.err), 1);
  command_release(&c);
  char *after = command_snapshot("o.records");
  assert_string_equal(before, after);
  free(before);
  free(after);
}

static void test_refused(void **state)
{
  (void)state;
  command_expect(0, ASKED, "-o", "whole", NULL);
  command_limit_files(40000);
  command_expect(1, ASKED, "-o", "o", NULL);
  command_limit_files(0);
  const char *const resume[] = {ASKED, "-o", "o", "--resume", NULL};
  const char *const anew[] = {ASKED, "-o", "o", NULL};
  const char *const other[] = {ASKED, "-o", "o", "--resume", "--nuisance", "zero_point:lwir", NULL};
  const char *const set[] = {ASKED, "-o", "o", "--resume", "--set", "optics.samples=33", NULL};
  char *text = command_read("m.csv");
  command_write("m.csv", "# another\n");
  FILE *file = fopen("m.csv", "a");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
  expect_refused(resume, "/m.csv has other bytes than when this was computed; accepted: that as it "
                         "was, or another -o, or this folder removed and no --resume");
  command_write("m.csv", text);
  free(text);
  expect_refused(other, "the options are others than when this was computed");
  expect_refused(set, "the changes by --set are others");
  expect_refused(anew, "points are on record there; accepted: to resume, or another folder");
  expect_resumed("o", "1");
}

/* One that was refused before anything was computed leaves nothing. */
static void test_nothing(void **state)
{
  (void)state;
  command_expect(1, ASKED, "-o", "o", "--nuisance", "no_such", NULL);
  assert_false(command_exists("o.records"));
  command_limit_files(6000);
  command_expect(1, "fit", BOX, "m.csv", "--add", "emittance:grey_white", "--add", "zero_point:vis",
                 "-o", "f", "--no-plots", NULL);
  command_limit_files(0);
  assert_true(command_exists("f.records"));
  command_expect(0, "fit", BOX, "m.csv", "--add", "emittance:grey_white", "--add", "zero_point:vis",
                 "-o", "f", "--no-plots", "--resume", NULL);
  assert_true(command_exists("f/fit.csv"));
  assert_false(command_exists("f.records"));
}

int main(void)
{
  static const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_ended, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_nothing, enter, command_leave)};
  return cmocka_run_group_tests_name("diagnose_resume", tests, NULL, NULL);
}
