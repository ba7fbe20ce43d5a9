/* What a terminal shows of a diagnosis: the sentence first, in the words of the effects, at most
 * twelve lines of 96 characters whatever the verdict and however much there is to say, and a
 * command that a shell takes as it stands. */
#include "evidence/diagnosis/report/brief.h"

#include <ctype.h>
#include <stdlib.h>

#include "evidence/diagnosis/report/text.h"
#include "evidence/diagnosis/summary.h"
#include "evidence/diagnosis/value_text.h"
#include "tests/evidence/diagnosis/report_test.h"

#define COMMAND "umbra diagnose scene m.csv"

static struct world w; /* one for all: it takes a run of the model */

static int make(void **state)
{
  if (set_up(state) != 0) return -1;
  world_make(&w);
  w.step[0].alternative[0].fitted = w.step[0].alternative[1].fitted = true;
  w.alternative[0].probability = 0.62;
  w.alternative[1].probability = 0.38;
  w.alternative[1].value[0] = 0.9;
  w.alternative[1].sigma[0] = 0.02;
  w.alternative[1].excluded_by_prior = false;
  w.d.naddition = 1;
  w.d.allowance = false;
  w.d.unexplained = NULL;
  w.d.sceptic = (struct um_diagnosis_sceptic){.asked = true,
                                              .frozen = 41.0,
                                              .search_p = 1.0 / 501.0,
                                              .variations = 22,
                                              .flips = 1,
                                              .flips_by = "one channel"};
  return 0;
}

static int end(void **state)
{
  world_end(&w);
  return tear_down(state);
}

/* ---- what holds for every brief ---- */

/* Lines, none longer than it may be; a line with a command or a path is as long as these are. */
static size_t check_lines(const char *brief)
{
  size_t n = 0;
  for (const char *at = brief; *at != '\0'; n++) {
    size_t length = strcspn(at, "\n");
    if (at[length] != '\n') fail_msg("a line without an end: %s", at);
    bool exempt = strstr(at, "type: umbra ") != NULL && strstr(at, "type: umbra ") < at + length;
    exempt = exempt || strncmp(at, "The rest is in ", 15) == 0;
    if (length > UM_DIAGNOSIS_BRIEF_WIDTH && !exempt) fail_msg("%zu bytes: %s", length, at);
    at += length + 1;
  }
  if (n > UM_DIAGNOSIS_BRIEF_LINES) fail_msg("%zu lines:\n%s", n, brief);
  return n;
}

static char *brief_of(const struct um_diagnosis *d)
{
  char *brief;
  assert_ok(um_diagnosis_report_brief(context, d, COMMAND, "out/my pass", &brief));
  print_message("%s\n", brief);
  check_lines(brief);
  return brief;
}

static void begins(const char *brief, const char *words)
{
  if (strncmp(brief, words, strlen(words)) != 0) fail_msg("not '%s' first:\n%s", words, brief);
}

static void has(const char *brief, const char *words)
{
  if (strstr(brief, words) == NULL) fail_msg("no '%s' in:\n%s", words, brief);
}

/* Wherever the lines break. */
static void says(const char *brief, const char *words)
{
  char *text = strdup(brief);
  assert_non_null(text);
  for (char *c = text; *c != '\0'; c++)
    if (*c == '\n') *c = ' ';
  has(text, words);
  free(text);
}

static void has_not(const char *brief, const char *words)
{
  if (strstr(brief, words) != NULL) fail_msg("'%s' in:\n%s", words, brief);
}

/* ---- verdicts ---- */

static struct um_diagnosis found(void)
{
  struct um_diagnosis d = w.d;
  d.verdict = UM_VERDICT_FOUND;
  w.step[0].confidence = UM_CONFIDENCE_CERTAIN;
  w.step[0].nalternative = 1;
  d.nnext = 0;
  d.residual = (struct um_missing_heat_residual){0};
  return d;
}

static void test_found(void **state)
{
  (void)state;
  struct um_diagnosis d = found();
  char *brief = brief_of(&d);
  begins(brief, "Missing: Electronics or heaters inside a part release heat (internal_power:bus "
                "power_W\n41.50 +- 0.70 W, power inside 66.50 +- 0.70 instead of 25 W; certain, 62 "
                "%).\nReduced chi-square ");
  has(brief, " -> ");
  has(brief, "\nTests of internal_power:bus: half of the time foretells the rest by 41 sigma, ");
  has(brief, " less than 0.2 % of searches,");
  has(brief, "1 of 22 changes (one channel) alters the answer.\n");
  has(brief, "\nTo see that it is gone, type: umbra compare 'out/my pass/improved' m.csv --out "
             "'out/my pass-after'\n");
  has(brief, "\nThe rest is in out/my pass/diagnosis.txt; to look at: out/my pass/report.html\n");
  um_core_free(context, brief);
  assert_ok(um_diagnosis_report_brief(context, &d, COMMAND, "out/", &brief));
  has(brief, " m.csv --out out-after\n"); /* beside the folder, not in it */
  um_core_free(context, brief);
  w.forward->options.allow_effects = true; /* the improved scenario has code in it */
  brief = brief_of(&d);
  w.forward->options.allow_effects = false;
  has(brief, " m.csv --allow-effects --out 'out/my pass-after'\n");
  um_core_free(context, brief);
}

/* In the words of its own description, whatever the effect: on the first line where it has room. */
static void test_every_effect(void **state)
{
  (void)state;
  struct um_diagnosis d = found();
  struct um_model_addition *a = &w.addition[0], kept = *a;
  for (size_t i = 0; i < um_effects_count(); i++) {
    char said[UM_DIAGNOSIS_SUMMARY_MAX], first[400], *brief;
    a->effect = w.step[0].addition.effect = um_effects_at(i);
    for (size_t p = 0; p < a->effect->nparameter; p++) {
      a->value[p] = a->effect->parameters[p].default_value;
      w.addition_sigma[0][p] = 0.1;
    }
    a->off = um_sensitivity_is_on(w.forward, a->effect);
    snprintf(first, sizeof first, "%s%s",
             a->off ? "Too much in the scenario: " : "Missing: ", a->effect->summary);
    if (a->off) first[26] = (char)tolower(first[26]); /* "MLI" is none of them */
    um_diagnosis_say_effects(&d, 1, said);
    begins(said, first);
    assert_ok(um_diagnosis_report_brief(context, &d, COMMAND, "out", &brief));
    check_lines(brief);
    if (strlen(first) <= UM_DIAGNOSIS_BRIEF_WIDTH) begins(brief, first);
    um_core_free(context, brief);
  }
  *a = kept;
  w.step[0].addition = kept;
  w.addition_sigma[0][0] = 0.7;
}

static void test_group(void **state)
{
  (void)state;
  struct um_diagnosis d = w.d;
  d.verdict = UM_VERDICT_NOT_IDENTIFIABLE;
  w.step[0].confidence = UM_CONFIDENCE_ONE_OF_GROUP;
  w.step[0].nalternative = 2;
  char *brief = brief_of(&d);
  begins(brief, "One of these, not known which: Electronics or heaters inside a part release heat\n"
                "(internal_power:bus power_W 41.50 +- 0.70 W, 62 %); or a surface emits");
  says(brief, "(emittance:grey_white factor 0.900 +- 0.020, 38 %). Reduced ");
  has(brief,
      "\nTo tell internal_power:bus from emittance:grey_white, measure: temperature of bus.+y");
  says(brief, ": 5 sigma by 3 values of sigma 0.3 K, 30 s of them. ");
  has(brief, "\nWhere you know that it is not internal_power:bus, type: " COMMAND
             " --exclude internal_power:bus --out 'out/my pass-without'\n");
  has_not(brief, "Missing");
  um_core_free(context, brief);
  /* who asks for passes reads of the best one first */
  struct um_diagnosis_pass pass[2] = {{.station = "Graz",
                                       .rise = d.next_of[0].from,
                                       .elevation = 0.5,
                                       .sun_elevation = -0.2,
                                       .of = "vis",
                                       .sigmas = 1.5,
                                       .seconds = NAN},
                                      {.station = "",
                                       .rise = d.next_of[0].from,
                                       .elevation = 1.0,
                                       .sun_elevation = -0.1,
                                       .of = "lwir",
                                       .sigmas = 7.25,
                                       .from = d.next_of[0].from + 60.0,
                                       .seconds = 42.0}};
  d.next_of[0].pass = pass;
  d.next_of[0].npass = 2;
  brief = brief_of(&d);
  says(brief, "To tell internal_power:bus from emittance:grey_white, of 2 passes the best is 20");
  says(brief, ", up to 57 deg, Sun at -6 deg: 7.2 sigma in lwir, 5 within 42 s from 20");
  um_core_free(context, brief);
  d.next_of[0].npass = 0;
  /* one folder is enough */
  assert_ok(um_diagnosis_report_brief(context, &d, "umbra diagnose a --out 'my b' c --out=d -o f",
                                      "e", &brief));
  has(brief, "type: umbra diagnose a c --exclude internal_power:bus --out e-without\n");
  um_core_free(context, brief);
}

/* What a scenario lists needs no file behind it: a command says only what it must. An abstaining
 * verdict accuses nobody, but what is certain stays certain. */
static void test_unexplained(void **state)
{
  (void)state;
  struct um_diagnosis d = w.d;
  static char channel[] = "temperature bus.+y", coordinate[] = "sun_on.grey_white_W_m2";
  d.verdict = UM_VERDICT_UNEXPLAINED;
  d.residual = (struct um_missing_heat_residual){
      .channel = channel, .coordinate = coordinate, .p = 1e-4, .chi2_reduced = 7.5, .mean = -2.0};
  w.step[0].confidence = UM_CONFIDENCE_ONE_OF_GROUP;
  d.unexplained = &w.unexplained;
  d.nnext = 0;
  char *brief = brief_of(&d);
  begins(brief,
         "The effects of the catalogue do not explain all of it. The scenario is off most in");
  has(brief, "measured 2 sigma below it on average");
  says(brief, "residual correlates with the sunlight on grey_white. Missing heat explains it: 4400 "
              "+- 300 J");
  /* what explains all is worth an effect of its own */
  says(brief, "To have it as an effect of your own, type: " COMMAND
              " --draft-effect mine.c --out 'out/my pass-draft'");
  has_not(brief, "internal_power");
  um_core_free(context, brief);
  d.light_asked.any = true; /* it is drafted */
  brief = brief_of(&d);
  has(brief, "\nTo see where it is off, type: umbra compare 'out/my pass/improved' m.csv --out "
             "'out/my pass-after'\n");
  um_core_free(context, brief);
  d.light_asked.any = false;
  struct um_missing_heat_unexplained part = w.unexplained;
  part.found = false;
  d.unexplained = &part; /* light explains all, heat a part */
  d.light = (struct um_missing_light){
      .any = true, .found = true, .worth = 100.0, .nband = 1, .band = {"vis"}, .nvalue = 1};
  brief = brief_of(&d);
  has(brief, "A correction of light explains");
  has_not(brief, "Missing heat");
  says(brief, "To have it as an effect of your own, type: ");
  um_core_free(context, brief);
  d.light.any = d.light.found = false;
  d.unexplained = &w.unexplained;
  w.step[0].confidence = UM_CONFIDENCE_CERTAIN;
  d.chosen = true;
  brief = brief_of(&d);
  has(brief, " Certain all the same: Electronics");
  has(brief, "\nTests of internal_power:bus: ");
  has_not(brief, "mimic");
  has(brief, "\nTo look through the whole catalogue, type: umbra diagnose 'out/my pass/improved' "
             "m.csv --out 'out/my pass-whole'\n");
  um_core_free(context, brief);
}

static void test_complete(void **state)
{
  (void)state;
  struct um_diagnosis d = w.d;
  d.verdict = UM_VERDICT_COMPLETE;
  d.naddition = d.nnuisance = d.nstep = d.nnext = 0;
  d.sceptic.asked = false;
  char *brief = brief_of(&d);
  begins(brief,
         "Nothing is missing: what is left is noise of the stated sigma.\nReduced chi-square ");
  has_not(brief, " -> ");
  has(brief, ", type: umbra sensitivity 'out/my pass/improved' --data m.csv --out 'out/my "
             "pass-sensitivity'\n");
  assert_int_equal(check_lines(brief), 4);
  um_core_free(context, brief);
  struct um_diagnosis_scatter scatter = {
      .channel = 0, .scale = 1.4, .along = "the phase of the orbit", .sigmas = 1.1, .share = 0.02};
  d.nscatter = 1;
  d.scatter = &scatter;
  d.noutlier = 6;
  brief = brief_of(&d);
  begins(brief,
         "Nothing is missing, but the model is off by 2 % rms (1.1 sigma) in band_irradiance");
  says(brief, "scatters 1.4 times its sigma; 6 rows are set aside as outliers. Reduced ");
  um_core_free(context, brief);
}

/* ---- room ---- */

/* Four effects, each certain, with a discrepancy, a next measurement and a long list of what was
 * not tried: the largest effects are said, the others counted. All stand in the whole sentence. */
static void test_four_effects(void **state)
{
  (void)state;
  static const char *const names[] = {"thin_film", "roughness", "heat_capacity", "internal_power"};
  static const double worth[] = {-100.0, -9000.0, -500.0, -4000.0};
  struct um_model_addition addition[4];
  double sigma[4][UM_EFFECT_PARAMETERS_MAX];
  struct um_diagnosis_step step[4];
  struct um_diagnosis_missed missed[9];
  struct um_diagnosis d = w.d;
  for (int i = 0; i < 4; i++) {
    addition[i] = (struct um_model_addition){
        .effect = effect_named(names[i]), .target = "bus", .value = {0.0}};
    for (size_t p = 0; p < UM_EFFECT_PARAMETERS_MAX; p++) {
      addition[i].value[p] = 1.0;
      sigma[i][p] = 0.1;
    }
    step[i] = w.step[0];
    step[i].addition = addition[i];
    step[i].confidence = UM_CONFIDENCE_CERTAIN;
    step[i].delta_bic = worth[i];
    step[i].nalternative = 1;
  }
  for (int i = 0; i < 9; i++) {
    missed[i] = (struct um_diagnosis_missed){.name = "panel_extraction:bus"};
    memset(missed[i].why, 'x', 120);
  }
  struct um_diagnosis_scatter scatter = {
      .channel = 0, .scale = 1.4, .along = "the phase of the orbit", .sigmas = 1.1, .share = 0.02};
  d.verdict = UM_VERDICT_FOUND;
  d.naddition = d.nstep = 4;
  d.addition = addition;
  d.addition_sigma = sigma;
  d.step = step;
  d.nscatter = 1;
  d.scatter = &scatter;
  d.chosen = true;
  d.nmissed = d.nasked = 9;
  d.missed = missed;
  char *brief = brief_of(&d);
  begins(brief, "Missing: The surface is rougher or smoother"); /* the largest */
  has(brief, " smaller ones more.\n");
  has_not(brief, "Films and covers");
  has(brief, "\nBesides, the model is off by ");
  has(brief, ", type: umbra compare ");
  um_core_free(context, brief);
  char whole[UM_DIAGNOSIS_SUMMARY_MAX];
  um_diagnosis_say_effects(&d, SIZE_MAX, whole);
  for (int i = 0; i < 4; i++) has(whole, addition[i].effect->summary);
  has_not(whole, " more.");
}

/* A text is cut at a word, and says so. */
static void test_wrap(void **state)
{
  (void)state;
  char text[1000] = "", *out = NULL;
  size_t n;
  for (int i = 0; i < 60; i++) strcat(text, i > 0 ? " word" : "word"); /* 299 bytes */
  strcat(text, " 1.25 +- 0.25 and 40 %");
  assert_int_equal(um_diagnosis_report_wrap(NULL, text, SIZE_MAX), 4);
  for (size_t most = 1; most <= 4; most++) {
    FILE *file = open_memstream(&out, &n);
    assert_non_null(file);
    assert_int_equal(um_diagnosis_report_wrap(file, text, most), most);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(check_lines(out), most);
    assert_int_equal(strcmp(out + n - 5, " ...\n") == 0, most < 4);
    free(out);
  }
  /* a value stays with its sigma, a number with its unit */
  memset(text, 'x', 90);
  strcpy(text + 90, " 1.25 +- 0.25");
  FILE *file = open_memstream(&out, &n);
  assert_non_null(file);
  assert_int_equal(um_diagnosis_report_wrap(file, text, SIZE_MAX), 2);
  assert_int_equal(fclose(file), 0);
  has(out, "x\n1.25 +- 0.25\n");
  free(out);
}

/* The rest: one line for all that nothing of the scenario tells from the winner. */
static void test_text(void **state)
{
  (void)state;
  struct um_diagnosis d = w.d;
  struct um_diagnosis_next next[3] = {w.next[1], w.next[1], w.next[0]};
  next[0].told_apart_by = "a: stars";
  next[1].candidate = 1;
  next[1].told_apart_by = "b: frames";
  next[2].candidate = 1;
  next[0].from = next[1].from = 0.0;
  d.nnext = 3;
  d.next_of = next;
  char *out = NULL;
  size_t n;
  FILE *file = open_memstream(&out, &n);
  assert_non_null(file);
  assert_ok(um_diagnosis_report_write_text(context, &d, file));
  assert_int_equal(fclose(file), 0);
  begins(out, "Missing: \"power\""); /* the summary */
  has(out, "\nverdict: not_identifiable\n");
  has(out, "\nstep 1: internal_power:bus\n");
  has(out, "  internal_power:bus from time_tag, emittance:grey_white: nothing that this scenario "
           "observes; told apart from a: stars\n");
  has_not(out, "b: frames");
  free(out);
}

/* Both to the second digit of sigma, however large. */
static void test_values(void **state)
{
  (void)state;
  static const struct {
    double value, sigma;
    const char *text;
  } cases[] = {{0.17968, 0.00271, "0.1797 +- 0.0027"},
               {-108135.3, 14147.0, "-108000 +- 14000"},
               {82.05, 0.9149, "82.05 +- 0.91"},
               {4412.0, 300.0, "4410 +- 300"},
               {2.5, NAN, "2.5"}};
  char text[80];
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    um_diagnosis_value_text(cases[i].value, cases[i].sigma, "+-", text);
    assert_string_equal(text, cases[i].text);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_found),    cmocka_unit_test(test_every_effect),
      cmocka_unit_test(test_group),    cmocka_unit_test(test_unexplained),
      cmocka_unit_test(test_complete), cmocka_unit_test(test_four_effects),
      cmocka_unit_test(test_wrap),     cmocka_unit_test(test_text),
      cmocka_unit_test(test_values),
  };
  return cmocka_run_group_tests(tests, make, end);
}
