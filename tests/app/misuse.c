/* Misuse: exit 2, what is wrong and the usage on standard error, nothing on standard output. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"

#define HELP_ONLY "umbra --help lists the commands"

static const struct misuse {
  const char *argument[10];
  const char *says, *usage;
} cases[] = {
    {{"compute"}, "unknown command 'compute'", HELP_ONLY},
    {{"run"}, "SCENARIO is missing", "usage: umbra run SCENARIO"},
    {{"run", "a", "b"}, "too many arguments: 'b'", "usage: umbra run"},
    {{"run", "a", "--outt", "x"}, "'--outt'", "usage: umbra run"},
    {{"run", "a", "-x"}, "'-x'", "usage: umbra run"},
    {{"run", "a", "--out"}, "'--out'", "usage: umbra run"},
    {{"run", "a", "--set", "x"}, "'x'", "usage: umbra run"},
    {{"run", "a", "--set"}, "'--set'", "usage: umbra run"},
    {{"run", "a", "--with"}, "'--with'", "usage: umbra run"},
    {{"run", "a", "--threads", "0"}, "'0'", "usage: umbra run"},
    {{"run", "a", "--threads", "two"}, "'two'", "usage: umbra run"},
    {{"run", "a", "--no-plots=1"}, "'--no-plots=1'", "usage: umbra run"},
    {{"run", "a", "--time", "now"}, "does not take --time", "usage: umbra run"},
    {{"check"}, "SCENARIO is missing", "usage: umbra check SCENARIO"},
    {{"check", "a", "--force"}, "does not take --force", "usage: umbra check"},
    {{"passes"}, "SCENARIO is missing", "usage: umbra passes SCENARIO"},
    {{"render", "a"}, "--time", "usage: umbra render SCENARIO"},
    {{"render", "a", "--time", "now", "--band", "vis"}, "-o", "usage: umbra render"},
    {{"render", "a", "--width", "0"}, "'0'", "usage: umbra render"},
    {{"render", "a", "--samples", "1.5"}, "'1.5'", "usage: umbra render"},
    {{"compare", "a"}, "MEASURED is missing", "usage: umbra compare SCENARIO MEASURED"},
    {{"compare", "a", "b", "c"}, "too many arguments: 'c'", "usage: umbra compare"},
    {{"diagnose", "a"}, "MEASURED is missing", "usage: umbra diagnose SCENARIO MEASURED"},
    {{"diagnose", "a", "b", "--level", "2"}, "'2'", "usage: umbra diagnose"},
    {{"diagnose", "a", "b", "--steps", "0"}, "'0'", "usage: umbra diagnose"},
    {{"diagnose", "a", "b", "--add", "x"}, "does not take --add", "usage: umbra diagnose"},
    {{"fit", "a", "b"}, "--add EFFECT[:TARGET]", "usage: umbra fit SCENARIO MEASURED"},
    {{"fit", "a", "b", "--only", "x"}, "does not take --only", "usage: umbra fit"},
    {{"synth", "a"}, "--noise REL[,FLOOR], --seed N and -o", "usage: umbra synth SCENARIO"},
    {{"synth", "a", "-o", "x", "--noise", "1,2,3", "--seed", "1"},
     "--noise takes",
     "usage: umbra synth"},
    {{"synth", "a", "-o", "x", "--noise", "1", "--seed", "-1"},
     "--seed takes",
     "usage: umbra synth"},
    {{"materials", "a", "b"}, "too many arguments: 'b'", "usage: umbra materials"},
    {{"effects", "--out", "x"}, "does not take --out", "usage: umbra effects"},
    {{"schema", "x"}, "too many arguments: 'x'", "usage: umbra schema"},
    {{"validate", "x"}, "too many arguments: 'x'", "usage: umbra validate"},
};

static void test_misuse(void **state)
{
  (void)state;
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct command c = command_run_list(cases[i].argument);
    if (c.code != 2 || c.out[0] != '\0' || strncmp(c.err, "umbra: ", 7) != 0 ||
        strstr(c.err, cases[i].says) == NULL || strstr(c.err, cases[i].usage) == NULL ||
        command_count_lines(c.err) != 2)
      fail_msg("case %zu: exit %d, said:\n%s%s", i, c.code, c.out, c.err);
    command_release(&c);
  }
  char *left = command_snapshot(".");
  assert_string_equal(left, "./\n");
  free(left);
}

/* Without a command the list of commands goes to standard error; asked for, to standard output. */
static void test_help(void **state)
{
  (void)state;
  struct command none = command_run(NULL, NULL), help = command_run("--help", NULL);
  assert_int_equal(none.code, 2);
  assert_string_equal(none.out, "");
  assert_int_equal(help.code, 0);
  assert_string_equal(help.err, "");
  assert_string_equal(help.out, none.err);
  static const char *const verbs[] = {"run",       "check",   "passes", "render",
                                      "materials", "effects", "schema", "validate"};
  for (size_t i = 0; i < sizeof verbs / sizeof verbs[0]; i++) {
    char usage[64];
    snprintf(usage, sizeof usage, "  umbra %s", verbs[i]);
    assert_non_null(strstr(help.out, usage));
    struct command verb = command_run(verbs[i], "--help", NULL);
    assert_int_equal(verb.code, 0);
    assert_int_equal(strncmp(verb.out, usage + 2, strlen(usage + 2)), 0);
    command_release(&verb);
  }
  command_release(&none);
  command_release(&help);
}

static void test_version(void **state)
{
  (void)state;
  struct command c = command_run("--version", NULL);
  assert_int_equal(c.code, 0);
  assert_int_equal(strncmp(c.out, "umbra ", 6), 0);
  assert_int_equal(command_count_lines(c.out), 1);
  command_release(&c);
}

/* Options may stand before and behind the scenario; "--" ends them. */
static void test_order_of_arguments(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, "check", "--set", "time.step_s=30", "box.yaml", "--without", "albedo", NULL);
  command_expect(0, "check", "--threads=1", "--", "box.yaml", NULL);
  command_expect(1, "check", "--", "--json", NULL);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_misuse, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_help, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_version, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_order_of_arguments, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
