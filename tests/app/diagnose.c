/* umbra diagnose and umbra fit: the files they make, verdicts that are right, and that what is
 * wrong is said in one line and leaves nothing behind. A lumped box over 3 minutes; few candidates.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/json.h"
#include "tests/app/table.h"

#define BOX        "box.yaml", "--set", "time.step_s=6", "--set", "time.start_utc=2016-09-06T18:08:00Z"
#define SYNTH(...) "synth", BOX, "--noise", "0.01,0.001", "--temperatures", "bus", __VA_ARGS__, NULL
#define FEW                                                                                        \
  "--only", "emittance", "--only", "area:bus", "--only", "zero_point", "--only", "albedo_level"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

/* The number behind "key": from `from` on. */
static double number_behind(const char *text, const char *from, const char *key)
{
  const char *at = strstr(text, from);
  if (at != NULL) at = strstr(at, key);
  if (at == NULL) fail_msg("no %s behind %s in:\n%s", key, from, text);
  return strtod(at + strlen(key), NULL);
}

/* What is printed is short, and the command that it says can be typed: it runs, and leaves
 * the diagnosis where it is. */
static void check_brief(const char *out)
{
  static const char type[] = "type: umbra ";
  char *argument[48], *command, *at;
  size_t n = 0;
  if (command_count_lines(out) > 12) fail_msg("more than 12 lines:\n%s", out);
  const char *said = strstr(out, type);
  if (said == NULL) fail_msg("no command in:\n%s", out);
  said += strlen(type);
  command = strndup(said, strcspn(said, "\n"));
  assert_non_null(command);
  assert_null(strchr(command, '\'')); /* nothing here needs quotes */
  for (char *word = strtok_r(command, " ", &at); word != NULL; word = strtok_r(NULL, " ", &at)) {
    assert_true(n + 1 < sizeof argument / sizeof argument[0]);
    argument[n++] = word;
  }
  argument[n] = NULL;
  const char *rest = strstr(out, "\nThe rest is in ");
  assert_non_null(rest);
  rest += strlen("\nThe rest is in ");
  char *text = strndup(rest, strcspn(rest, ";"));
  assert_non_null(text);
  char *before = command_read(text);
  struct command c = command_run_list((const char *const *)argument);
  if (c.code != 0) fail_msg("'%s': exit %d: %s", said, c.code, c.err);
  char *after = command_read(text);
  assert_string_equal(before, after);
  free(before);
  free(after);
  free(text);
  command_release(&c);
  free(command);
}

/* A hidden emittance of 0.8 of the scenario's is found: value within three of its sigmas; reduced
 * chi-square of 93 rows of white noise within 1 +- 3 sqrt(2/93); the improved scenario alone has it
 * too. */
static void test_found(void **state)
{
  (void)state;
  const char *where;
  command_expect(0,
                 SYNTH("--seed", "5", "-o", "m.csv", "--with", "emittance:grey_white,factor=0.8"));
  struct command c = command_run("diagnose", BOX, "m.csv", "--out", "out", FEW, "--json", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  char *json = command_read("out/diagnosis.json");
  assert_string_equal(json, c.out);
  if (!json_is_valid(json, &where)) fail_msg("not JSON from here on: %.60s", where);
  assert_non_null(strstr(json, "\"verdict\": \"found\""));
  double value = number_behind(json, "\"steps\"", "\"factor\", \"value\": ");
  double sigma = number_behind(json, "\"steps\"", "\"sigma\": ");
  assert_true(fabs(value - 0.8) <= 3.0 * sigma && sigma < 0.01);
  assert_true(number_behind(json, "\"baseline\"", "\"chi2_red\": ") > 10.0);
  assert_close(number_behind(json, "\"final\"", "\"chi2_red\": "), 1.0, 3.0 * sqrt(2.0 / 93.0));
  free(json);
  command_release(&c);
  static const char *const made[] = {"diagnosis.txt", "ranking.csv", "fit.csv",
                                     "improved/scenario.yaml", "plots.gp"};
  for (size_t i = 0; i < sizeof made / sizeof made[0]; i++) {
    char path[64];
    snprintf(path, sizeof path, "out/%s", made[i]);
    if (!command_exists(path)) fail_msg("no %s", path);
  }
  c = command_run("compare", "out/improved", "m.csv", "--no-plots", "--out", "two", "--json", NULL);
  assert_int_equal(c.code, 0);
  assert_close(number_behind(c.out, "{", "\"chi2_red\": "), 1.0, 3.0 * sqrt(2.0 / 93.0));
  command_release(&c);
  struct table t = table_read("out/fit.csv");
  assert_int_equal(t.nrow, 93);
  table_release(&t);
  c = command_run("diagnose", BOX, "m.csv", "--out", "out", FEW, "--no-plots", NULL);
  assert_int_equal(c.code, 0);
  static const char begins[] = "Missing: A surface emits and absorbs thermal radiation better or "
                               "worse than its record\n(emittance:grey_white factor 0.";
  if (strncmp(c.out, begins, strlen(begins)) != 0) fail_msg("%s", c.out);
  check_brief(c.out);
  command_release(&c);
}

/* BIC of an alternative above the winner's by diagnosis.json. */
static double behind_in(const char *json, const char *winner, const char *other)
{
  const char *alternatives = strstr(json, "\"alternatives\"");
  assert_non_null(alternatives);
  return number_behind(alternatives, other, "\"bic\": ") -
         number_behind(alternatives, winner, "\"bic\": ");
}

/* What was fitted and is worse stands on the terminal by how much its BIC is above the winner's,
 * and what is more than 100 above it only in the files: diagnosis.json and the picture of the
 * ranking have both. */
static void test_worse(void **state)
{
  (void)state;
#define EMITTANCE "\"emittance\", \"target\": \"grey_white\""
#define ZERO      "\"zero_point\", \"target\": \"lwir\""
  static const struct {
    const char *truth, *winner, *other, *told;
    bool far;
  } cases[] = {
      {"zero_point:lwir,factor=0.96", ZERO, EMITTANCE,
       "\n  fitted and worse: emittance:grey_white factor ", false},
      {"emittance:grey_white,factor=0.6", EMITTANCE, ZERO,
       "\n  fitted and worse: zero_point:lwir factor ", true},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--seed", "5", "-o", "m.csv",
                   "--force", "--with", cases[i].truth, NULL);
    struct command c =
        command_run("diagnose", BOX, "m.csv", "--out", "out", FEW, "--details", NULL);
    if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
    char *json = command_read("out/diagnosis.json"), *script = command_read("out/plots.gp");
    double behind = behind_in(json, cases[i].winner, cases[i].other);
    const char *worse = strstr(c.out, cases[i].told);
    print_message("%s: %.4g behind\n", cases[i].truth, behind);
    assert_true((behind > 100.0) == cases[i].far && behind > 15.0);
    if ((worse == NULL) != cases[i].far) fail_msg("%s in:\n%s", cases[i].told, c.out);
    if (worse != NULL) assert_close(number_behind(worse, ", BIC ", "+"), behind, 0.0501);
    assert_true((strstr(c.out, "fitted and worse: diagnosis.json has ") != NULL) == cases[i].far);
    char text[64];
    snprintf(text, sizeof text, " %+.4g   ", behind);
    if (strstr(script, text) == NULL) fail_msg("no %s in plots.gp", text);
    free(script);
    free(json);
    command_release(&c);
  }
}

/* One that could be any of five: the sentence is first, alternatives that the same would tell are
 * one line, and what could not be tried is named. */
static void test_group(void **state)
{
  (void)state;
  command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--seed", "5", "-o", "m.csv", "--with",
                 "zero_point:vis,factor=0.95", NULL);
  char *text = command_read("m.csv"), *only = calloc(strlen(text) + 1, 1);
  assert_non_null(only);
  for (char *line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n"))
    if (strstr(line, ",lwir,") == NULL) strcat(strcat(only, line), "\n");
  command_write("v.csv", only);
  free(only);
  free(text);
  struct command c =
      command_run("diagnose", BOX, "v.csv", "--no-plots", "--only", "zero_point:vis", "--only",
                  "area:bus", "--only", "diffuse_level", "--only", "extinction:vis", "--only",
                  "specular_level", "--out", "out", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  assert_int_equal(strncmp(c.out, "One of these, not known which: ", 31), 0);
  check_brief(c.out);
  command_release(&c);
  c = command_run("diagnose", BOX, "v.csv", "--no-plots", "--only", "zero_point:vis", "--only",
                  "area:bus", "--only", "diffuse_level", "--only", "extinction:vis", "--only",
                  "specular_level", "--out", "out", "--details", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  text = command_read("out/diagnosis.txt");
  assert_int_equal(strncmp(c.out, text, strlen(text)), 0);
  assert_string_equal(c.out + strlen(text), "results in out\nto look at: out/report.html\n");
  free(text);
  const char *next = strstr(c.out, "\nnext measurement, to tell\n");
  assert_non_null(next);
  const char *same = strstr(next, "  extinction:vis from zero_point:vis, diffuse_level:grey_white: "
                                  "nothing that this scenario observes; told apart from ");
  if (same == NULL) fail_msg("not one line: %s", next);
  assert_null(strstr(same + 2, "  extinction:vis from diffuse_level"));
  const char *missed = strstr(c.out, "\nnot tried\n");
  assert_non_null(missed);
  assert_non_null(
      strstr(missed, "\n  specular_level:grey_white: no observation changes with it\n"));
  command_release(&c);
}

/* Heat of thin air, depth 0.1, and the light of a sky that grows as fast toward the horizon: one of
 * a group, though the depth of 0.3 that a search for such air begins with explains less than the
 * sky does. */
static void test_unknown_shape(void **state)
{
  (void)state;
#define DAWN UMBRA_SOURCE_DIR "/scenarios/hidden-effect/dawn"
  command_expect(0, "synth", DAWN, "--noise", "0.01", "--seed", "2", "-o", "m.csv", "--with",
                 "path_radiance:lwir,irradiance_W_m2=2e-13,depth=0.1", NULL);
  struct command c = command_run("diagnose", DAWN, "m.csv", "--no-plots", "--out", "out", "--only",
                                 "path_radiance", "--only", "sky_background", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  if (strncmp(c.out, "One of these, not known which: ", 31) != 0 ||
      strstr(c.out, "path_radiance:lwir") == NULL || strstr(c.out, "sky_background:lwir") == NULL)
    fail_msg("no group of both: %s", c.out);
  char *json = command_read("out/diagnosis.json");
  assert_null(strstr(json, "\"not_tried\": true")); /* it was fitted */
  free(json);
  command_release(&c);
}

/* FUNcube-1 as it is: an albedo 8 % higher leaves white noise, but a little error of the model
 * along the orbit explains as much. So nothing is missing, and the error is said. Without the
 * albedo it is named all the same. */
static void test_discrepancy(void **state)
{
  (void)state;
#define FUNCUBE UMBRA_SOURCE_DIR "/scenarios/funcube-1"
  struct command c =
      command_run("diagnose", FUNCUBE, FUNCUBE "/measured-10min.csv", "--no-plots", "--out", "out",
                  "--only", "albedo_level", "--only", "earth_ir_level", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  if (strncmp(c.out, "Nothing is missing, but the model is off by 0.7", 47) != 0 ||
      strstr(c.out, "along the phase of the orbit") == NULL)
    fail_msg("not complete with a discrepancy: %s", c.out);
  command_release(&c);
  c = command_run("diagnose", FUNCUBE, FUNCUBE "/measured-10min.csv", "--no-plots", "--out", "two",
                  "--without", "albedo", "--only", "albedo", "--only", "earth_ir_level", NULL);
  if (strncmp(c.out, "Missing: Sunlight reflected by the Earth heats the satellite (albedo; ",
              70) != 0)
    fail_msg("albedo is not named: %s%s", c.out, c.err);
  command_release(&c);
}

/* A complete model is called so, and a person can read it. */
static void test_complete(void **state)
{
  (void)state;
  command_expect(0, SYNTH("--seed", "6", "-o", "m.csv"));
  struct command c = command_run("diagnose", BOX, "m.csv", "--only", "emittance", "--only",
                                 "zero_point", "--no-plots", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  assert_int_equal(strncmp(c.out, "Nothing is missing: ", 20), 0); /* the sentence is first */
  check_brief(c.out);
  /* changed on the command line, so not in the folder of the scenario as it is */
  const char *said = strstr(c.out, "The rest is in out/box--set-time.step_s=6--set-");
  assert_non_null(said);
  char folder[128], path[160];
  said += strlen("The rest is in ");
  const char *end = strstr(said, "/diagnosis.txt; to look at: ");
  assert_non_null(end);
  snprintf(folder, sizeof folder, "%.*s", (int)(end - said), said);
  snprintf(path, sizeof path, "%s/diagnosis.txt", folder);
  char *text = command_read(path);
  assert_int_equal(strncmp(text, "Nothing is missing: ", 20), 0);
  assert_non_null(strstr(text, "\nbox against m.csv: 93 observations, "));
  assert_non_null(strstr(text, "\nbaseline: reduced chi-square "));
  assert_non_null(strstr(text, "\n  temperature bus "));
  assert_non_null(strstr(text, "\nverdict: complete\n"));
  free(text);
  snprintf(path, sizeof path, "%s/improved/scenario.yaml", folder);
  assert_true(command_exists(path));
  snprintf(path, sizeof path, "%s/plots.gp", folder);
  assert_false(command_exists(path));
  assert_false(command_exists("out/box"));
  command_release(&c);
}

/* Standard error is a pipe here: a diagnosis that lasts longer than a second, as one of 1000
 * observations and the whole catalogue does, says there how far it is, one line a time. */
static void test_progress(void **state)
{
  (void)state;
  static const char fine[] = "time.step_s=0.5", from[] = "time.start_utc=2016-09-06T18:08:00Z";
  command_expect(0, "synth", "box.yaml", "--set", fine, "--set", from, "--noise", "0.01,0.001",
                 "--seed", "6", "-o", "m.csv", NULL);
  struct command c = command_run("diagnose", "box.yaml", "m.csv", "--set", fine, "--set", from,
                                 "--no-plots", NULL);
  size_t done, total, lines = 0;
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  for (const char *line = c.err; *line != '\0'; line += strcspn(line, "\n"), line += *line == '\n')
    lines += sscanf(line, "%*[a-z ]: %zu of %zu", &done, &total) == 2 && done < total;
  if (lines == 0) fail_msg("no progress in: %s", c.err);
  assert_null(strchr(c.err, '\r')); /* no bar that is drawn over itself */
  command_release(&c);
}

/* A chosen effect beside a nuisance: both in the improved scenario. */
static void test_fit(void **state)
{
  (void)state;
  command_expect(0,
                 SYNTH("--seed", "7", "-o", "m.csv", "--with", "emittance:grey_white,factor=0.8"));
  struct command c =
      command_run("fit", BOX, "m.csv", "--add", "emittance:grey_white,factor=0.9", "--nuisance",
                  "zero_point:vis,sigma=0.1", "--out", "out", "--no-plots", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  static const char begins[] = "Fitted: A surface emits and absorbs thermal radiation ";
  assert_int_equal(strncmp(c.out, begins, strlen(begins)), 0);
  check_brief(c.out);
  char *tables = command_read("out/diagnosis.txt");
  assert_non_null(strstr(tables, "\nfitted: emittance:grey_white\n"));
  assert_non_null(strstr(tables, "\nfitted along: zero_point:vis\n"));
  free(tables);
  assert_false(command_exists("out/ranking.csv"));
  char *text = command_read("out/improved/scenario.yaml");
  assert_non_null(strstr(text, "step_s: 6"));
  /* in the order of the catalogue: light before the detector */
  const char *emittance = strstr(text, "effects:\n  - {effect: emittance, target: grey_white, ");
  assert_non_null(emittance);
  assert_non_null(strstr(emittance, "\n  - {effect: zero_point, target: vis, factor: "));
  double value = number_behind(text, "effect: emittance", "factor: ");
  assert_close(value, 0.8, 0.03); /* sigma is below 0.01 */
  free(text);
  command_release(&c);
}

/* Draws beside it: the table has one row each and units in its head, their weights sum to 1, curves
 * stand in the rows of fit.csv, the pair is drawn. */
static void test_posterior(void **state)
{
  (void)state;
  command_expect(0,
                 SYNTH("--seed", "7", "-o", "m.csv", "--with", "emittance:grey_white,factor=0.8"));
  struct command c = command_run("fit", BOX, "m.csv", "--add", "emittance:grey_white", "--nuisance",
                                 "zero_point:vis,sigma=0.1", "--posterior", "--draws", "300",
                                 "--out", "out", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  assert_non_null(strstr(c.out, "\nposterior: 300 draws, effective number "));
  assert_non_null(strstr(c.out, "\n  emittance:grey_white factor "));
  assert_non_null(strstr(c.out, " instead of "));
  char *text = command_read("out/posterior.csv");
  assert_int_equal(strncmp(text, "weight,emittance:grey_white factor,zero_point:vis factor\n", 56),
                   0);
  double sum = 0.0, mean = 0.0, weight, value;
  size_t rows = 0;
  for (const char *line = strchr(text, '\n') + 1; *line != '\0'; line = strchr(line, '\n') + 1) {
    assert_int_equal(sscanf(line, "%lf,%lf", &weight, &value), 2);
    sum += weight;
    mean += weight * value;
    rows++;
  }
  assert_int_equal(rows, 300);
  assert_close(sum, 1.0, 1e-6);
  assert_close(mean, 0.8, 0.03); /* sigma is below 0.01 */
  free(text);
  text = command_read("out/posterior_curves.csv");
  char *fitted = command_read("out/fit.csv");
  assert_int_equal(command_count_lines(text), command_count_lines(fitted));
  assert_int_equal(strncmp(text, "time_utc,quantity,of,low_5,median,high_95\n", 42), 0);
  free(text);
  free(fitted);
  text = command_read("out/diagnosis.json");
  assert_close(number_behind(text, "\"posterior\": {", "\"median\": "), mean, 0.005);
  free(text);
  assert_true(command_exists("out/posterior.png"));
  command_release(&c);
  c = command_run("fit", BOX, "m.csv", "--add", "emittance:grey_white", "--draws", "30", NULL);
  assert_int_equal(c.code, 2);
  assert_non_null(strstr(c.err, "--draws needs --posterior"));
  command_release(&c);
}

/* One line beside what is said of the progress, exit 1, nothing written. */
static void refused(const char *says, const char *verb, const char *option, const char *value)
{
  char *before = command_snapshot(".");
  struct command c = command_run(verb, BOX, "m.csv", "--out", "out", option, value, NULL);
  char *after = command_snapshot(".");
  const char *line = strstr(c.err, "umbra: ");
  if (c.code != 1 || c.out[0] != '\0' || line == NULL || command_count_lines(line) != 1 ||
      strstr(line, says) == NULL)
    fail_msg("exit %d, said:\n%s%s, expected '%s'", c.code, c.out, c.err, says);
  assert_string_equal(before, after);
  free(before);
  free(after);
  command_release(&c);
}

static void test_refused(void **state)
{
  (void)state;
  command_expect(0, SYNTH("--seed", "6", "-o", "m.csv"));
  refused("--only gravity: no effect is called 'gravity'", "diagnose", "--only", "gravity");
  refused("--only heater:wing: nothing that 'heater' acts on is called 'wing'", "diagnose",
          "--only", "heater:wing");
  refused("--exclude gravity: no effect is called 'gravity'", "diagnose", "--exclude", "gravity");
  refused("--nuisance gravity: no effect is called 'gravity'", "diagnose", "--nuisance", "gravity");
  refused("--nuisance zero_point:swir: nothing that 'zero_point' acts on is called 'swir'",
          "diagnose", "--nuisance", "zero_point:swir");
  refused("--nuisance zero_point:vis,sigma=0: sigma '0'; accepted: ", "diagnose", "--nuisance",
          "zero_point:vis,sigma=0");
  refused("--add internal_power: effect 'internal_power' needs a target", "fit", "--add",
          "internal_power");
  refused("fits any measurement; accepted: per set", "diagnose", "--nuisance",
          "attitude_offset,sigma=free,per=observation");
  refused("measurements.nuisance", "diagnose", "--set",
          "measurements={nuisance: [{effect: gravity}]}");
  command_write("m.csv", "time_utc,quantity,of,value,sigma\n"
                         "2016-09-06T18:10:00Z,temperature,wing,280,1\n");
  refused("m.csv:2: column 'of': the scenario has no place 'wing'", "diagnose", "--level", "0.05");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_found, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_worse, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_group, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_unknown_shape, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_discrepancy, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_complete, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_progress, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_fit, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_posterior, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
