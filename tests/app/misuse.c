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
    {{"compute"}, "unknown command 'compute'; did you mean 'compare'?", HELP_ONLY},
    {{"gravity"}, "unknown command 'gravity'", HELP_ONLY},
    {{"valdiate", "--json"}, "did you mean 'validate'?", HELP_ONLY},
    {{"help", "rnu"}, "unknown command 'rnu'; did you mean 'run'?", "usage: umbra help [COMMAND]"},
    {{"completion"}, "SHELL is missing", "usage: umbra completion SHELL"},
    {{"completion", "fish"}, "accepted: bash, zsh", "usage: umbra completion SHELL"},
    {{"run"}, "SCENARIO is missing", "usage: umbra run SCENARIO"},
    {{"run", "a", "b"}, "too many arguments: 'b'", "usage: umbra run"},
    {{"run", "a", "--outt", "x"}, "'--outt'; did you mean '--out'?", "usage: umbra run"},
    {{"run", "a", "-x"}, "'-x'", "usage: umbra run"},
    {{"run", "a", "--out"}, "'--out' wants a value", "usage: umbra run"},
    {{"run", "a", "--set", "x"}, "'x'", "usage: umbra run"},
    {{"run", "a", "--set"}, "'--set'", "usage: umbra run"},
    {{"run", "a", "--with"}, "'--with'", "usage: umbra run"},
    {{"run", "a", "--threads", "0"}, "'0'", "usage: umbra run"},
    {{"run", "a", "--threads", "two"}, "'two'", "usage: umbra run"},
    {{"run", "a", "--no-polts"}, "did you mean '--no-plots'?", "usage: umbra run"},
    {{"run", "a", "-o"}, "'-o' wants a value", "usage: umbra run"},
    {{"validate", "--th"}, "ambiguous option '--th'", "usage: umbra validate"},
    {{"run", "a", "--no-plots=1"},
     "'--no-plots=1': this option takes no value",
     "usage: umbra run"},
    {{"run", "a", "--time", "now"}, "does not take --time", "usage: umbra run"},
    {{"check"}, "SCENARIO is missing", "usage: umbra check SCENARIO"},
    {{"check", "a", "--days"}, "does not take --days", "usage: umbra check"},
    {{"forecast"}, "SCENARIO is missing", "usage: umbra forecast SCENARIO"},
    {{"forecast", "a", "--times", "--out", "x"},
     "--out does not go with --times",
     "usage: umbra forecast"},
    {{"forecast", "a", "--times", "--workers", "2"},
     "--workers does not go with --times",
     "usage: umbra forecast"},
    {{"render", "a"}, "-o FILE is missing", "usage: umbra render SCENARIO|PICTURE.nc"},
    {{"render", "a", "-o", "x.exr"}, "--time UTC, --band B is missing", "usage: umbra render"},
    {{"render", "a", "-o", "x", "--time", "now"}, "--band B is missing", "usage: umbra render"},
    {{"render", "a", "-o", "x.FITS"}, "--time UTC, --sensor S is missing", "usage: umbra render"},
    {{"render", "a", "-o", "x", "--sensor", "s"}, "--time UTC is missing", "usage: umbra render"},
    {{"render", "a", "-o", "x.exr", "--psf", "airy"},
     "--psf goes with a frame of a sensor (-o FILE.fits), not with a picture of a scenario",
     "usage: umbra render"},
    {{"render", "a", "-o", "x.nc", "--sensor", "s"},
     "--sensor goes with a frame of a sensor (-o FILE.fits), not with a picture of a scenario",
     "usage: umbra render"},
    {{"render", "a", "-o", "x.fits", "--band", "vis"},
     "--band goes with a picture of a scenario (-o FILE.exr, FILE.nc), not with a frame",
     "usage: umbra render"},
    {{"render", "p.nc", "-o", "x.exr", "--without", "albedo"},
     "(-o FILE.fits), not with a part of a factored picture (PICTURE.nc -o FILE.exr)",
     "usage: umbra render"},
    {{"render", "p.nc", "-o", "x.fits", "--no-plots"},
     "--no-plots goes with a frame of a sensor (-o FILE.fits), not with a part",
     "usage: umbra render"},
    {{"render", "a", "--time", "now", "--band", "vis"},
     "-o FILE is missing",
     "usage: umbra render"},
    {{"render", "a", "--width", "0"}, "'0'", "usage: umbra render"},
    {{"render", "a", "--samples", "1.5"}, "'1.5'", "usage: umbra render"},
    {{"compare"}, "SCENARIO is missing", "usage: umbra compare SCENARIO [MEASURED...]"},
    {{"retrieve", "a"}, "MEASURED is missing", "usage: umbra retrieve SCENARIO MEASURED"},
    {{"retrieve", "a", "b", "c"}, "too many arguments: 'c'", "usage: umbra retrieve"},
    {{"diagnose"}, "SCENARIO is missing", "usage: umbra diagnose SCENARIO [MEASURED...]"},
    {{"diagnose", "a", "b", "--level", "2"}, "'2'", "usage: umbra diagnose"},
    {{"diagnose", "a", "b", "--steps", "0"}, "'0'", "usage: umbra diagnose"},
    {{"diagnose", "a", "b", "--add", "x"}, "does not take --add", "usage: umbra diagnose"},
    {{"fit", "a", "b"}, "--add EFFECT[:TARGET]", "usage: umbra fit SCENARIO [MEASURED...]"},
    {{"fit", "a", "b", "--only", "x"}, "does not take --only", "usage: umbra fit"},
    {{"synth", "a"},
     "--noise REL[,FLOOR], --seed N, -o FILE is missing",
     "usage: umbra synth SCENARIO"},
    {{"synth", "a", "-o", "x", "--noise", "1,2,3", "--seed", "1"},
     "--noise takes",
     "usage: umbra synth"},
    {{"synth", "a", "-o", "x", "--noise", "1", "--seed", "-1"},
     "--seed takes",
     "usage: umbra synth"},
    {{"map"}, "SCENARIO is missing", "usage: umbra map SCENARIO"},
    {{"map", "a", "--step", "7"}, "--step takes a part of 90 deg", "usage: umbra map"},
    {{"map", "a", "--phase-angles", "30,10"}, "rising", "usage: umbra map"},
    {{"map", "a", "--phase-angles", "180"}, "below 180 deg", "usage: umbra map"},
    {{"map", "a", "--planes", "0"}, "'0'", "usage: umbra map"},
    {{"map", "a", "--tolerance", "2"}, "--tolerance takes 0", "usage: umbra map"},
    {{"attitude", "a"}, "MEASURED is missing", "usage: umbra attitude SCENARIO MEASURED"},
    {{"attitude", "a", "b", "--period", "5,3"}, "--period takes", "usage: umbra attitude"},
    {{"attitude", "a", "b", "--axis-step", "0"}, "--axis-step takes", "usage: umbra attitude"},
    {{"list"}, "WHAT is missing", "usage: umbra list WHAT [ITEM]"},
    {{"list", "planets"},
     "nothing is listed under 'planets'; accepted: materials, filters, sensors, effects, keys, "
     "scenarios",
     "usage: umbra list"},
    {{"list", "materials", "a", "b"}, "too many arguments: 'b'", "usage: umbra list"},
    {{"list", "effects", "--band", "x"}, "does not take --band", "usage: umbra list"},
    {{"list", "effects", "--out", "x"},
     "--out belongs to umbra list materials",
     "usage: umbra list"},
    {{"list", "keys", "--no-plots"},
     "--no-plots belongs to umbra list materials",
     "usage: umbra list"},
    {{"list", "filters", "--effect-file", "x"},
     "--effect-file belongs to umbra list effects",
     "usage: umbra list"},
    {{"material", "panel"},
     "accepted: --from-brdf FILE, --from-profile FILE, --from-reflectance FILE",
     "usage: umbra material"},
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

/* `umbra VERB --help`, `-h` and `umbra help VERB` are one page: usage, every option of the usage
 * line explained, an example of the verb, exit codes; lines of at most 80 characters behind the
 * usage. */
static void check_page(const char *verb)
{
  struct command a = command_run(verb, "--help", NULL), b = command_run("help", verb, NULL);
  struct command c = command_run(verb, "-h", NULL);
  char begin[64], example[64];
  snprintf(begin, sizeof begin, "umbra %s", verb);
  snprintf(example, sizeof example, "\nExamples:\n  umbra %s", verb);
  assert_int_equal(a.code, 0);
  assert_string_equal(a.err, "");
  assert_string_equal(a.out, b.out);
  assert_string_equal(a.out, c.out);
  assert_int_equal(strncmp(a.out, begin, strlen(begin)), 0);
  const char *options = strstr(a.out, "\nOptions:\n"), *usage_end = strchr(a.out, '\n');
  if (options == NULL || strstr(a.out, example) == NULL ||
      strstr(a.out, "\nExit status:\n  0  done\n  1  failed") == NULL ||
      strstr(a.out, "\n  2  misuse") == NULL || strstr(a.out, "\n  4  done, but ") == NULL)
    fail_msg("%s --help lacks a section:\n%s", verb, a.out);
  for (const char *at = strstr(a.out, "--"); at != NULL && at < usage_end;
       at = strstr(at + 2, "--")) {
    char name[64];
    snprintf(name, sizeof name, " %.*s", (int)strcspn(at, " ]\n"), at);
    if (strstr(options, name) == NULL) fail_msg("%s --help does not explain%s", verb, name);
  }
  for (const char *line = usage_end; line != NULL && strstr(line, "\nExamples:") != NULL;
       line = strchr(line + 1, '\n'))
    if (strcspn(line + 1, "\n") > 80) fail_msg("%s --help: %.100s", verb, line + 1);
  command_release(&a);
  command_release(&b);
  command_release(&c);
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
  static const char *const verbs[] = {"run",      "check",    "forecast",   "render", "compare",
                                      "diagnose", "fit",      "synth",      "period", "list",
                                      "material", "validate", "completion", "help"};
  for (size_t i = 0; i < sizeof verbs / sizeof verbs[0]; i++) {
    char usage[64];
    snprintf(usage, sizeof usage, "  umbra %s", verbs[i]);
    assert_non_null(strstr(help.out, usage));
    check_page(verbs[i]);
  }
  command_release(&none);
  command_release(&help);
}

/* Values that the program has without an option stand in its help. */
static void test_help_of_defaults(void **state)
{
  (void)state;
  static const struct {
    const char *verb, *holds[3];
  } defaults[] = {{"render", {"Pixels of a line, up to 8192. Default: 512; of a", "Required."}},
                  {"synth", {"Default: FLOOR 0.001.", "Noise of temperatures [K]. Default: 0.5."}},
                  {"diagnose", {"Default: 0.01.", "Default: 4.", "Example: --level 0.001"}}};
  for (size_t i = 0; i < sizeof defaults / sizeof defaults[0]; i++) {
    struct command c = command_run("help", defaults[i].verb, NULL);
    for (size_t k = 0; k < 3 && defaults[i].holds[k] != NULL; k++)
      if (strstr(c.out, defaults[i].holds[k]) == NULL)
        fail_msg("help %s: no '%s' in\n%s", defaults[i].verb, defaults[i].holds[k], c.out);
    command_release(&c);
  }
}

static void test_version(void **state)
{
  (void)state;
  struct command c = command_run("--version", NULL);
  assert_int_equal(c.code, 0);
  int major, minor, patch;
  char end = '\0';
  assert_int_equal(sscanf(c.out, "umbra %d.%d.%d%c", &major, &minor, &patch, &end), 4);
  assert_true(end == '\n');
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

/* A time that is none is the option's fault, not a key's that it becomes. */
static void test_time(void **state)
{
  (void)state;
  struct command c =
      command_run("render", "a", "--time", "2020", "--band", "vis", "-o", "x.exr", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "umbra: --time: '2020' is not a UTC time"));
  command_release(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_misuse, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_help, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_help_of_defaults, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_version, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_order_of_arguments, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_time, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
