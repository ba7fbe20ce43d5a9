/* umbra diagnose --draft-effect: measurements are made with an effect that no catalogue has, the
 * draft is written, compiled as its first comment says, loaded and added. On light that had no say,
 * seen from another station, it takes away most of chi-square above its expectation. At its null
 * values it leaves every number as it is. Hidden are a pulse of heat, a bank of cloud of sharp edge
 * and a lamp: none is a curve of effects/curve.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/json.h"

#define BOX                                                                                        \
  "box.yaml", "--set", "time.step_s=4", "--set", "time.start_utc=2016-09-06T18:09:00Z", "--set",   \
      "time.stop_utc=2016-09-06T18:16:00Z"
#define ELSEWHERE                                                                                  \
  "--set", "observer.station.latitude_deg=49", "--set", "observer.station.longitude_deg=13"

#define HEAD                                                                                       \
  "#include \"effects/effect.h\"\n"                                                                \
  "static const struct um_effect_parameter parameters[] = {{.name = \"share\", .unit = \"1\",\n"   \
  "  .help = \"how much\", .null_value = 0.0, .default_value = 1.0, .minimum = -9.0,\n"            \
  "  .maximum = 9.0, .prior_sigma = 1.0}};\n"
#define TAIL(hooks)                                                                                \
  "const struct um_effect um_effect = {UM_EFFECT_ABI, .name = \"hidden\", .summary = "             \
  "\"hidden\",\n"                                                                                  \
  "  .reference = \"none\", .validity = \"here\", .targets = UM_TARGET_GLOBAL,\n"                  \
  "  UM_EFFECT_PARAMETERS(parameters), .hooks = {" hooks "}};\n"
#define ON_LIGHT(statement)                                                                        \
  HEAD                                                                                             \
      "static enum um_status light(struct um_context *context, const struct um_effect_use *use,\n" \
      "  struct um_effect_observation *o)\n{ (void)context; double share = use->value[0];\n "      \
      " " statement "\n  return UM_OK; }\n" TAIL(".observation = light")

/* Two rectangles of heat of different height, 60 s and 60 s. */
static const char heat[] = HEAD
    "static enum um_status part(struct um_context *context, const struct um_effect_use *use,\n"
    "  const char *name, struct um_thermal_part_spec *spec)\n{ (void)context; (void)name;\n"
    "  for (int i = 0; i < 2 && use->value[0] != 0.0; i++)\n"
    "    spec->timed[spec->ntimed++] = (struct um_thermal_timed){.place = \"+z\",\n"
    "      .power = (300.0 - 60.0 * i) * use->value[0], .course = {UM_HEAT_PULSE,\n"
    "      use->epoch + 90.0 + 60.0 * i, 60.0, NAN}};\n  return UM_OK; }\n" TAIL(".part = part");
static const char cloud[] =
    ON_LIGHT("if (!o->exo_atmospheric && o->elevation < 0.5) o->value *= 1.0 - 0.2 * share;");
static const char lamp[] =
    ON_LIGHT("if (o->view != NULL && o->band[0] == 'v' && o->view->observer.x > 0.0)\n"
             "    o->value += share * 20.0 * o->view->observer.x * o->view->observer.x /\n"
             "                (o->view->range * o->view->range);");

static const struct {
  const char *name, *hidden, *says; /* what stands in the draft */
  const char *half;                 /* what is wrong */
} cases[] = {{"heat", heat, "UM_HEAT_PULSE", "heat"},
             {"cloud", cloud, "1.0 + f * um_effect_share(o->view, MATERIAL)", "air"},
             {"lamp", lamp, "o->value += f / (o->view->range * o->view->range);", "surface"}};
#define CASES (sizeof cases / sizeof cases[0])

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  char *box = command_edit(command_data("box.yaml"), "lvlh: {}",
                           "spin: {axis_lvlh: [0, 1, 0], axis_body: [0.3, 1, 0], period_s: 90}");
  command_write("box.yaml", box);
  free(box);
  return 0;
}

/* NAME.so of NAME.c, as the draft says it: with every warning an error. */
static void compile(const char *name)
{
  char command[1024];
  snprintf(command, sizeof command,
           "%s -std=c17 -O2 -Wall -Wextra -Werror -shared -fPIC -I%s -o %s.so %s.c", UMBRA_CC,
           UMBRA_SOURCE_DIR, name, name);
  if (system(command) != 0) fail_msg("does not compile: %s", command);
}

static double number_behind(const char *text, const char *key)
{
  const char *at = strstr(text, key);
  if (at == NULL) fail_msg("no %s in:\n%s", key, text);
  return strtod(at + strlen(key), NULL);
}

/* Chi-square less its degrees of freedom of what another station saw, with an effect or none. */
static double excess(const char *with)
{
  struct command c = with == NULL
                         ? command_run("compare", BOX, ELSEWHERE, "other.csv", "--no-plots",
                                       "--out", "out/compare", "--force", "--json", NULL)
                         : command_run("compare", BOX, ELSEWHERE, "other.csv", "--no-plots",
                                       "--out", "out/compare", "--force", "--effect-file",
                                       "./mine.so", "--with", with, "--json", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  double value = number_behind(c.out, "\"chi2\": ") - number_behind(c.out, "\"dof\": ");
  command_release(&c);
  return value;
}

/* "mine,NAME=0,..." with all that the draft fits at nothing. */
static void null_use(const char *draft, char *out, size_t size)
{
  size_t used = (size_t)snprintf(out, size, "mine");
  for (const char *p = draft; (p = strstr(p, ".name = \"")) != NULL; p++) {
    const char *name = p + 9, *end = strchr(name, '"'), *next = strstr(end, ".name = \"");
    const char *null = strstr(name, ".null_value = "), *chosen = strstr(name, ".chosen = true");
    if (null == NULL || (next != NULL && null > next)) continue;
    if (chosen != NULL && (next == NULL || chosen < next)) continue;
    used += (size_t)snprintf(out + used, size - used, ",%.*s=0", (int)(end - name), name);
  }
}

static char *curve_of(const char *with)
{
  if (with == NULL)
    command_expect(0, "run", BOX, "--no-plots", "--out", "out/run", "--force", NULL);
  else
    command_expect(0, "run", BOX, "--no-plots", "--out", "out/run", "--force", "--effect-file",
                   "./mine.so", "--with", with, NULL);
  return command_read("out/run/lightcurve.csv");
}

/* What every effect is held to (tests/effects/conformance.c): nothing at its null values, and
 * something away from them. */
static void conforms(const char *draft)
{
  char with[1024];
  null_use(draft, with, sizeof with);
  char *plain = curve_of(NULL), *null = curve_of(with), *found = curve_of("mine");
  assert_string_equal(plain, null);
  assert_string_not_equal(plain, found);
  free(plain);
  free(null);
  free(found);
  struct command page = command_run("list", "effects", "mine", "--effect-file", "./mine.so", NULL);
  assert_int_equal(page.code, 0);
  assert_non_null(strstr(page.out, "acts on: everything"));
  command_release(&page);
}

/* Probabilities of the halves add to one, and that one is the largest. */
static void check_halves(const char *json, const char *half)
{
  static const char *const halves[] = {"heat",         "surface", "geometry_attitude",
                                       "earth_shadow", "air",     "instrument"};
  const char *at = strstr(json, "\"halves\": {");
  double sum = 0.0, of = 0.0;
  assert_non_null(at);
  for (size_t h = 0; h < 6; h++) {
    char key[40];
    snprintf(key, sizeof key, "\"%s\": ", halves[h]);
    double p = number_behind(at, key);
    sum += p;
    if (strcmp(halves[h], half) == 0) of = p;
  }
  assert_close(sum, 1.0, 1e-6);
  if (!(of > 0.5)) fail_msg("%s with %g: %.300s", half, of, at);
}

static void draft_explains_elsewhere(void **state)
{
  (void)state;
  for (size_t i = 0; i < CASES; i++) {
    const char *where;
    command_write("hidden.c", cases[i].hidden);
    compile("hidden");
    command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--seed", "5", "--force", "-o",
                   "m.csv", "--effect-file", "./hidden.so", "--with", "hidden", NULL);
    command_expect(0, "synth", BOX, ELSEWHERE, "--noise", "0.01,0.001", "--seed", "6", "--force",
                   "-o", "other.csv", "--effect-file", "./hidden.so", "--with", "hidden", NULL);
    struct command c =
        command_run("diagnose", BOX, "m.csv", "--no-plots", "--out", "out", "--force", "--only",
                    "zero_point:lwir", "--draft-effect", "mine.c", "--json", NULL);
    if (c.code != 0) fail_msg("%s: exit %d: %s", cases[i].name, c.code, c.err);
    if (!json_is_valid(c.out, &where)) fail_msg("not JSON from here on: %.60s", where);
    check_halves(c.out, cases[i].half);
    command_release(&c);
    char *draft = command_read("mine.c");
    if (strstr(draft, cases[i].says) == NULL)
      fail_msg("%s: no %s in:\n%s", cases[i].name, cases[i].says, draft);
    compile("mine");
    conforms(draft);
    double before = excess(NULL), after = excess("mine");
    print_message("%s: excess %.5g, with the draft %.4g: %.1f %% taken away\n", cases[i].name,
                  before, after, 100.0 * (1.0 - after / before));
    assert_true(before > 500.0 && after < 0.2 * before);
    free(draft);
  }
}

/* A draft that is there is kept, before anything is computed; one that is compiled is a candidate
 * of the next diagnosis, which finds it. */
static void draft_is_kept_and_used(void **state)
{
  (void)state;
  command_write("hidden.c", cloud);
  compile("hidden");
  command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--seed", "5", "-o", "m.csv",
                 "--effect-file", "./hidden.so", "--with", "hidden", NULL);
  command_write("mine.c", "/* of the user */\n");
  struct command c = command_run("diagnose", BOX, "m.csv", "--no-plots", "--only",
                                 "zero_point:lwir", "--draft-effect", "mine.c", NULL);
  assert_int_not_equal(c.code, 0);
  assert_non_null(strstr(c.err, "mine.c: it is there already; accepted: another name, or --force"));
  command_release(&c);
  assert_false(command_exists("out"));
  char *kept = command_read("mine.c");
  assert_string_equal(kept, "/* of the user */\n");
  free(kept);
  c = command_run("diagnose", BOX, "m.csv", "--draft-effect", "mine.so", NULL);
  assert_int_not_equal(c.code, 0);
  assert_non_null(strstr(c.err, "accepted: a name that ends in .c"));
  command_release(&c);
  command_expect(0, "diagnose", BOX, "m.csv", "--no-plots", "--only", "zero_point:lwir",
                 "--draft-effect", "mine.c", "--force", NULL);
  compile("mine");
  c = command_run("diagnose", BOX, "m.csv", "--no-plots", "--force", "--effect-file", "./mine.so",
                  "--only", "mine", "--only", "zero_point", "--json", NULL);
  if (c.code != 0) fail_msg("exit %d: %s", c.code, c.err);
  assert_non_null(strstr(c.out, "\"verdict\": \"found\""));
  const char *effects = strstr(c.out, "\"effects\": [");
  assert_true(effects != NULL && strstr(effects, "\"effect\": \"mine\"") != NULL);
  command_release(&c);
}

/* Of a complete model there is nothing to draft, and the results are written all the same. */
static void nothing_to_draft(void **state)
{
  (void)state;
  command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--seed", "5", "-o", "m.csv", NULL);
  struct command c = command_run("diagnose", BOX, "m.csv", "--no-plots", "--out", "out", "--only",
                                 "zero_point:lwir", "--draft-effect", "mine.c", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.err, "mine.c is not written"));
  assert_false(command_exists("mine.c"));
  assert_true(command_exists("out/diagnosis.json"));
  command_release(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(draft_explains_elsewhere, enter, command_leave),
      cmocka_unit_test_setup_teardown(draft_is_kept_and_used, enter, command_leave),
      cmocka_unit_test_setup_teardown(nothing_to_draft, enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
