/* replay.json beside results, and umbra replay: the same results again, what has changed is named,
 * and a record from somebody else can do no more than its reader allows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/app/command.h"
#include "tests/app/json.h"

#define RUN "run", "box.yaml", "--no-plots"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

static void expect_in(const char *text, const char *wanted)
{
  if (strstr(text, wanted) == NULL) fail_msg("no '%s' in:\n%s", wanted, text);
}

/* Run; the exit status, and what stands in what it says on standard error. */
static void expect_said(const char *const *arguments, int code, const char *says)
{
  struct command c = command_run_list(arguments);
  if (c.code != code || (says != NULL && strstr(c.err, says) == NULL))
    fail_msg("%s: exit %d, expected %d and '%s':\n%s%s", arguments[1], c.code, code, says, c.out,
             c.err);
  command_release(&c);
}
#define SAYS(code, says, ...) expect_said((const char *[]){__VA_ARGS__, NULL}, code, says)

/* Refused in one line, and nothing is written. */
static void expect_refused(const char *const *arguments, const char *says)
{
  char *before = command_snapshot(".");
  struct command c = command_run_list(arguments);
  char *after = command_snapshot(".");
  if (c.code != 1 || strstr(c.err, says) == NULL || command_count_lines(c.err) != 1)
    fail_msg("exit %d, expected '%s':\n%s%s", c.code, says, c.out, c.err);
  assert_string_equal(after, before);
  free(before);
  free(after);
  command_release(&c);
}
#define REFUSED(says, ...) expect_refused((const char *[]){__VA_ARGS__, NULL}, says)

/* A record by hand. arguments, inputs: what stands in the brackets. */
static void write_record(const char *path, const char *arguments, const char *inputs)
{
  char text[2048], here[1024];
  assert_non_null(getcwd(here, sizeof here));
  snprintf(text, sizeof text,
           "{\"umbra_replay\": 1, \"version\": \"0.0.1\", \"arguments\": [%s],\n"
           " \"folder\": \"%s\", \"written_utc\": \"2026-01-01T00:00:00Z\", \"inputs\": [%s]}\n",
           arguments, here, inputs);
  command_write(path, text);
}

static void test_is_written(void **state)
{
  (void)state;
  char here[1024], wanted[1200];
  const char *where;
  struct stat st;
  command_write("a.csv", "a");
  command_expect(0, RUN, "--threads", "2", "--set", "summary=\"two words\"", "-o", "out", NULL);
  char *text = command_read("out/replay.json");
  if (!json_is_valid(text, &where)) fail_msg("no JSON at: %s", where);
  expect_in(text, "\"arguments\": [\"run\", \"box.yaml\", \"--no-plots\", \"--threads\", \"2\", "
                  "\"--set\", \"summary=\\\"two words\\\"\", \"-o\", \"out\"]");
  assert_non_null(getcwd(here, sizeof here));
  snprintf(wanted, sizeof wanted, "\"folder\": \"%s\"", here);
  expect_in(text, wanted);
  assert_int_equal(stat("box.yaml", &st), 0);
  snprintf(wanted, sizeof wanted, "{\"path\": \"box.yaml\", \"bytes\": %ld, ", (long)st.st_size);
  expect_in(text, wanted);
  expect_in(text, "\"written_utc\": \"20");
  /* what comes with the program is not an input */
  assert_null(strstr(text, "grey_white"));
  free(text);
  /* a command that fails says so, and leaves no record */
  command_expect(1, "import", "a.csv", "--time", "t", "-o", "b.csv", "--replay", "r.json", NULL);
  assert_false(command_exists("r.json"));
  /* a verb by its name of now */
  command_expect(0, "passes", "box.yaml", "--days", "0.02", "--replay", "r.json", NULL);
  text = command_read("r.json");
  expect_in(text, "\"arguments\": [\"forecast\", \"--times\", \"box.yaml\", ");
  free(text);
  /* a folder that is the user's has none */
  command_expect(0, "new", "mine", NULL);
  assert_false(command_exists("mine/replay.json"));
}

static void test_same_again(void **state)
{
  (void)state;
  static const char *const tables[] = {"lightcurve.csv", "temperatures.csv", NULL};
  command_expect(0, RUN, "--set", "time.step_s=30", "-o", "out/", NULL);
  char *before = command_snapshot("out");
  SAYS(0, "replays: umbra run box.yaml --no-plots --set time.step_s=30 --out ", "replay", "out");
  command_expect_same("out", "out--replayed", tables);
  /* from elsewhere, and to where it is said; options may end before */
  assert_int_equal(mkdir("elsewhere", 0777), 0);
  assert_int_equal(chdir("elsewhere"), 0);
  command_expect(0, "replay", "../out/replay.json", "-o", "again", NULL);
  assert_int_equal(chdir(".."), 0);
  command_expect_same("out", "elsewhere/again", tables);
  command_expect(0, "run", "--no-plots", "--set", "time.step_s=30", "-o", "dash", "--", "box.yaml",
                 NULL);
  command_expect(0, "replay", "dash", NULL);
  command_expect_same("out", "dash--replayed", tables);
  /* data that the environment names from here */
  assert_int_equal(symlink(UMBRA_MATERIALS, "materials"), 0);
  assert_int_equal(setenv("UMBRA_DATA", "..", 1), 0);
  assert_int_equal(chdir("elsewhere"), 0);
  command_expect(0, "replay", "../out", "-o", "data", NULL);
  assert_int_equal(chdir(".."), 0);
  assert_int_equal(unsetenv("UMBRA_DATA"), 0);
  command_expect_same("out", "elsewhere/data", tables);
  /* what is replayed stays, whatever is asked */
  char *after = command_snapshot("out");
  assert_string_equal(after, before);
  free(after);
  REFUSED("holds the results that are replayed", "replay", "out", "-o", "out");
  REFUSED("holds the results that are replayed", "replay", "out/replay.json", "-o", "./out",
          "--force");
  SAYS(2, "-o is missing", "replay", "out/replay.json");
  after = command_snapshot("out");
  assert_string_equal(after, before);
  free(before);
  free(after);
}

/* Digests are of the bytes: the same size and another letter is another file. FNV-1a of 64 bits of
 * "a" is af63dc4c8601ec8c, by the table of its authors. */
static void test_changes_are_named(void **state)
{
  (void)state;
  command_expect(0, RUN, "-o", "out", NULL);
  struct command c = command_run("replay", "out", NULL);
  assert_null(strstr(c.err, "warning: "));
  command_release(&c);
  char *text = command_edit(command_read("box.yaml"), "name: box", "name: b0x");
  command_write("box.yaml", text);
  free(text);
  SAYS(0, "warning: box.yaml: has changed since it was read", "replay", "out");
  write_record("r.json", "\"run\", \"box.yaml\", \"--no-plots\"",
               "{\"path\": \"gone.csv\", \"bytes\": 1, \"fnv1a64\": \"af63dc4c8601ec8c\"},"
               "{\"path\": \"a.csv\", \"bytes\": 1, \"fnv1a64\": \"af63dc4c8601ec8c\"}");
  command_write("a.csv", "a");
  c = command_run("replay", "r.json", "-o", "r", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.err, "warning: gone.csv: was read then and is missing now\n");
  expect_in(c.err, "warning: the results are of umbra 0.0.1; this is ");
  assert_null(strstr(c.err, "a.csv: has"));
  command_release(&c);
  assert_true(command_exists("r/replay.json"));
}

/* Commands whose result is one file. */
static void test_files(void **state)
{
  (void)state;
  command_write("lc.csv", "t,V\n2016-09-06T18:09:00Z,8\n2016-09-06T18:10:00Z,7\n");
  command_expect(0, "import", "lc.csv", "--time", "t", "--magnitude", "V", "-o", "m.csv",
                 "--replay", "m.json", NULL);
  char *record = command_read("m.json"), *first = command_read("m.csv");
  expect_in(record, "{\"path\": \"lc.csv\", \"bytes\": 50, ");
  free(record);
  SAYS(2, "-o is missing", "replay", "m.json");
  SAYS(1, "m.csv: exists", "replay", "m.json", "-o", "m.csv");
  command_expect(0, "replay", "m.json", "-o", "n.csv", NULL);
  char *second = command_read("n.csv");
  assert_string_equal(second, first);
  free(second);
  free(first);
  /* nothing is written over, and only where it can be written */
  REFUSED("m.json: exists", "import", "lc.csv", "--time", "t", "--magnitude", "V", "-o", "p.csv",
          "--replay", "m.json");
  REFUSED("no folder/r.json: there is no such folder", "list", "effects", "--replay",
          "no folder/r.json");
  REFUSED("no '.csv' is written here", "list", "effects", "--replay", "r.csv");
  command_expect(0, "list", "effects", "albedo", "--replay", "e.json", NULL);
  SAYS(2, "writes nothing", "replay", "e.json", "-o", "x");
  command_expect(0, "replay", "e.json", NULL);
  /* of commands that write, those that only print */
  command_expect(0, "passes", "box.yaml", "--days", "0.02", "--replay", "t.json", NULL);
  command_expect(0, "replay", "t.json", NULL);
  command_expect(0, "check", "box.yaml", "--replay", "c.json", NULL);
  command_expect(0, "replay", "c.json", NULL);
  assert_false(command_exists("out"));
}

/* Somebody's file. */
static void test_hostile(void **state)
{
  (void)state;
  static const struct {
    const char *arguments, *says;
  } cases[] = {
      {"\"rum\", \"box.yaml\"", "h.json: unknown command 'rum'; did you mean 'run'?"},
      {"\"replay\", \"h.json\"", "h.json: umbra replay is not replayed"},
      {"\"serve\", \"box.yaml\"", "h.json: umbra serve is not replayed"},
      {"\"new\", \"x\"", "h.json: umbra new is not replayed"},
      {"\"help\"", "h.json: umbra help is not replayed"},
      {"\"completion\", \"bash\"", "h.json: umbra completion is not replayed"},
      {"", "h.json: arguments: is empty"},
      {"[\"run\"]", "h.json:1: arguments"},
      {"{\"a\": 1}", "h.json:1: arguments"},
      {"\"run\", \"box.yaml\", \"--effect-file\", \"x.so\"", "h.json: its command loads code"},
      {"\"run\", \"box.yaml\", \"--effect-f=x.so\"", "h.json: its command loads code"},
      {"\"run\", \"box.yaml\", \"--allow-effects\"", "h.json: its command loads code"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    write_record("h.json", cases[i].arguments, "");
    REFUSED(cases[i].says, "replay", "h.json", "-o", "out");
  }
  write_record("h.json", "\"run\", \"box.yaml\", \"--effect-file\", \"x.so\"", "");
  SAYS(1, "--effect-file: x.so", "replay", "h.json", "-o", "out", "--allow-effects");
  assert_false(command_exists("out"));
  /* misuse of the verb, as typed */
  write_record("h.json", "\"run\", \"box.yaml\", \"--nonsense\"", "");
  SAYS(2, "unknown or ambiguous option '--nonsense'", "replay", "h.json", "-o", "out");
  /* where results go, and what they replace, is not for the record to say */
  command_write("thesis.tex", "years of work\n");
  write_record("h.json",
               "\"run\", \"box.yaml\", \"--no-plots\", \"-o\", \"mine\", \"--force\", "
               "\"--replay=thesis.tex\"",
               "");
  assert_int_equal(mkdir("mine", 0777), 0);
  command_write("mine/thesis.tex", "years of work\n");
  char *before = command_snapshot("mine");
  command_expect(0, "replay", "h.json", "-o", "out", NULL);
  char *after = command_snapshot("mine"), *thesis = command_read("thesis.tex");
  assert_string_equal(after, before);
  assert_string_equal(thesis, "years of work\n");
  free(thesis);
  free(before);
  free(after);
  SAYS(1, "mine: exists and was not written by Umbra", "replay", "h.json", "-o", "mine");
}

/* No record at all. */
static void test_not_a_record(void **state)
{
  (void)state;
  assert_int_equal(mkdir("empty", 0777), 0);
  REFUSED("empty/replay.json: No such file or directory", "replay", "empty");
  REFUSED("box.yaml:3: schema: unknown key 'schema'; accepted: umbra_replay, ", "replay",
          "box.yaml", "-o", "x");
  command_write("h.json", "[1, 2]\n");
  REFUSED("h.json", "replay", "h.json", "-o", "x");
  command_write("h.json", "{\"umbra_replay\": 2, \"version\": \"9\", \"arguments\": []}\n");
  REFUSED("h.json:1: umbra_replay: 2", "replay", "h.json", "-o", "x");
  command_write("h.json", "{\"umbra_replay\": 1, \"version\": \"9\"");
  REFUSED("h.json", "replay", "h.json", "-o", "x");
  char *large = malloc(3 << 20);
  assert_non_null(large);
  memset(large, ' ', 3 << 20);
  command_write_bytes("h.json", large, 3 << 20);
  free(large);
  REFUSED("h.json: larger than the 2097152 bytes accepted", "replay", "h.json", "-o", "x");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_is_written, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_same_again, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_changes_are_named, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_files, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_hostile, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_not_a_record, enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
