/* The files of a diagnosis, from one that is filled by hand: its numbers stand where they belong,
 * the improved scenario is the model that was diagnosed, and a folder that cannot be written is
 * not there. */
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/measurements.h"
#include "compare/synth.h"
#include "compare/write.h"
#include "core/csv.h"
#include "core/file.h"
#include "diagnosis/report/plot.h"
#include "diagnosis/report/plot_frame_impl.h"
#include "diagnosis/report/write.h"
#include "diagnosis/request.h"
#include "effects/effects.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "tests/app/json.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

/* A box and a panel from a file, on the pass of ENVISAT over Graz that begins in the umbra.
 * Isothermal at the start, so that a model and its copy do the same arithmetic. */
static const char scenario_text[] =
    "# a box and a panel\n"
    "schema: 1\n"
    "name: pass\n"
    "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:14:00Z, step_s: 12}\n"
    "orbit:\n"
    "  tle_file: orbit.tle # of the day\n"
    "attitude:\n"
    "  - spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 240}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "parts:\n"
    "  - name: bus\n"
    "    box: {size_m: [1, 1, 1]}\n"
    "    outside: grey_white\n"
    "    shell: {areal_heat_capacity_J_m2_K: 3000}\n"
    "    interior: {capacity_J_K: 4000, power_W: 20, conductance_W_K: 2}\n"
    "    lumped: true\n"
    "  - name: panel\n"
    "    mesh: panel.obj\n"
    "    pose: {position_m: [0, 3, 0]}\n"
    "    front: grey_panel\n"
    "    back: grey_metal\n"
    "    shell: {areal_heat_capacity_J_m2_K: 2000, through_conductance_W_m2_K: 50}\n"
    "    lumped: true\n"
    "thermal: {start: isothermal, orbits_before: 0.05}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n"
    "effects:\n"
    "  - {effect: panel_extraction, target: panel, efficiency: 0.1} # guessed\n"
    "measurements:\n"
    "  nuisance: [{effect: zero_point, target: lwir, sigma: 0.02}]\n"
    "  exclude: [time_tag]\n";
static const char tle_text[] =
    "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";
static const char panel_text[] =
    "v -1 -0.5 0\nv 1 -0.5 0\nv 1 0.5 0\nv -1 0.5 0\ng plate\nf 1 2 3 4\n";

static struct um_context *context;
static char base[UM_TEST_PATH];

static void put(const char *path, const char *text)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
  assert_int_equal(fclose(file), 0);
}

#define assert_ok(call)                                                                            \
  do {                                                                                             \
    um_core_message_clear(context);                                                                \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static int set_up(void **state)
{
  (void)state;
  if (um_test_folder_create(base) != 0 || chdir(base) != 0 || mkdir("scene", 0777) != 0) return -1;
  put("scene/scenario.yaml", scenario_text);
  put("scene/orbit.tle", tle_text);
  put("scene/panel.obj", panel_text);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  remove("scene/scenario.yaml");
  remove("scene/orbit.tle");
  remove("scene/panel.obj");
  return rmdir("scene") == 0 && chdir("/") == 0 && um_test_folder_remove(base) == 0 ? 0 : -1;
}

/* ---- a diagnosis by hand ---- */

static const char *const overrides[] = {"parts.bus.interior.power_W=25"};
static const char *const with[] = {"solar_absorptance:grey_white,absorptance_shift=0.05"};
static const char *const without[] = {"albedo"};
static const struct um_model_options changes = {.overrides = overrides,
                                                .noverride = 1,
                                                .with = with,
                                                .nwith = 1,
                                                .without = without,
                                                .nwithout = 1};

struct world {
  struct um_compare_measurements *measurements;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidate candidate[3];
  struct um_sensitivity_candidates candidates;
  struct um_diagnosis_alternative ranking[3], alternative[2];
  struct um_diagnosis_step step[1];
  struct um_model_addition addition[2], nuisance[1];
  double addition_sigma[2][UM_EFFECT_PARAMETERS_MAX], nuisance_sigma[1][UM_EFFECT_PARAMETERS_MAX];
  struct um_diagnosis_next next[2];
  struct um_diagnosis_superseded superseded;
  struct um_missing_heat_unexplained unexplained;
  struct um_missing_heat heat;
  double edge[41], history[40], history_sigma[40];
  struct um_diagnosis d;
};

static const struct um_effect *effect_named(const char *name)
{
  const struct um_effect *effect = um_effects_find(name);
  assert_non_null(effect);
  return effect;
}

/* Measurements of the scenario with more power inside, in both bands and of two places, by synth,
 * and one magnitude. */
static void measure(void)
{
  static const char *const hot[] = {"parts.bus.interior.power_W=25",
                                    "effects.panel_extraction:panel.efficiency=0.2"};
  static const char *const powered[] = {"solar_absorptance:grey_white,absorptance_shift=0.05",
                                        "internal_power:bus,power_W=40"};
  const struct um_model_options truth = {.overrides = hot,
                                         .noverride = 2,
                                         .with = powered,
                                         .nwith = 2,
                                         .without = without,
                                         .nwithout = 1};
  static const char *const place[] = {"bus.interior", "panel.front"};
  const struct um_compare_synth noise = {.relative = 0.01,
                                         .floor = 0.002,
                                         .seed = 5,
                                         .place = place,
                                         .nplace = 2,
                                         .temperature_sigma = 0.3};
  struct um_model *model;
  struct um_model_precomputed *precomputed;
  struct um_model_result *result;
  struct um_compare_measurements *made;
  assert_ok(um_model_create(context, "scene", &truth, &model));
  assert_ok(um_model_precompute(context, model, &precomputed));
  assert_ok(um_model_run(context, model, precomputed, &result));
  assert_ok(um_compare_synth_create(context, model, precomputed, result, &noise, "m.csv", &made));
  assert_ok(um_compare_measurements_write(context, made, "m.csv"));
  FILE *file = fopen("m.csv", "ab");
  assert_non_null(file);
  fputs("2016-09-06T18:14:00Z,magnitude_ab,vis,5.5,0.02\n", file);
  assert_int_equal(fclose(file), 0);
  um_compare_measurements_destroy(context, &made);
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  um_model_destroy(context, &model);
}

static double chi2_of(const struct um_sensitivity_forward *f, const double *value)
{
  double sum = 0.0;
  for (size_t i = 0; i < f->observations.count; i++)
    sum += pow((f->observations.measured[i] - value[i]) / f->observations.sigma[i], 2.0);
  return sum;
}

static void candidate(struct world *w, size_t i, const char *effect, char *target, char *name,
                      double chi2, double estimate)
{
  w->candidate[i] = (struct um_sensitivity_candidate){
      .name = name, .effect = effect_named(effect), .target = target, .ncolumn = 1};
  w->ranking[i] = (struct um_diagnosis_alternative){.candidate = i,
                                                    .score = {.statistic = chi2,
                                                              .dof = 1.0,
                                                              .p = 1e-9,
                                                              .p_corrected = 3e-9,
                                                              .estimate = {estimate},
                                                              .sigma = {0.1 * fabs(estimate)},
                                                              .kept = 0.9}};
}

static void unexplained(struct world *w)
{
  double first = w->forward->observations.t[0];
  for (int i = 0; i <= 40; i++) w->edge[i] = first + 9.0 * i;
  for (int i = 0; i < 40; i++) {
    w->history[i] = 60.0 * exp(-pow((i - 18.0) / 5.0, 2.0)) + 3.0 * sin(2.3 * i);
    w->history_sigma[i] = 6.0;
  }
  static char place[] = "bus.interior", coordinate[] = "time_s", channel[] = "temperature bus";
  w->heat = (struct um_missing_heat){.place = place,
                                     .chi2_explained = 400.0,
                                     .start = first + 120.0,
                                     .stop = first + 200.0,
                                     .start_sigma = 4.0,
                                     .power = 55.0,
                                     .energy = 4400.0,
                                     .energy_sigma = 300.0,
                                     .nbin = 40,
                                     .t = w->edge,
                                     .heat = w->history,
                                     .sigma = w->history_sigma};
  w->unexplained = (struct um_missing_heat_unexplained){.coordinate = coordinate,
                                                        .channel = channel,
                                                        .p = 1e-5,
                                                        .nheat = 1,
                                                        .heat = &w->heat,
                                                        .chi2_before = 600.0,
                                                        .chi2_after = 200.0,
                                                        .found = true};
}

static void world_make(struct world *w)
{
  static char power[] = "internal_power:bus", mli[] = "emittance:grey_white", tag[] = "time_tag";
  static char bus[] = "bus", white[] = "grey_white", sentence[] = "Missing: \"power\"\nand more.";
  static char what[] = "temperature of bus.+y in the umbra", of[] = "bus.+y";
  *w = (struct world){0};
  measure();
  assert_ok(um_compare_measurements_read(context, "m.csv", &w->measurements));
  assert_ok(
      um_sensitivity_forward_create(context, "scene", &changes, w->measurements, 1.0, &w->forward));
  struct um_diagnosis *d = &w->d;
  size_t n = w->forward->observations.count;
  w->addition[0] = (struct um_model_addition){effect_named("internal_power"), "bus", {41.5}};
  w->addition[1] = (struct um_model_addition){effect_named("panel_extraction"), "panel", {0.1875}};
  w->nuisance[0] = (struct um_model_addition){effect_named("zero_point"), "lwir", {1.0078125}};
  w->addition_sigma[0][0] = 0.7;
  w->addition_sigma[1][0] = 0.01;
  w->nuisance_sigma[0][0] = 0.003;
  candidate(w, 0, "internal_power", bus, power, 5000.0, 40.0);
  candidate(w, 1, "emittance", white, mli, 4000.0, -0.1);
  candidate(w, 2, "time_tag", NULL, tag, 3.0, 0.2);
  w->candidates =
      (struct um_sensitivity_candidates){.count = 3, .nobservation = n, .candidate = w->candidate};
  *d = (struct um_diagnosis){.verdict = UM_VERDICT_NOT_IDENTIFIABLE,
                             .sentence = sentence,
                             .level = 0.01,
                             .forward = w->forward,
                             .candidates = &w->candidates,
                             .nstep = 1,
                             .step = w->step,
                             .naddition = 2,
                             .addition = w->addition,
                             .addition_sigma = w->addition_sigma,
                             .nnuisance = 1,
                             .nuisance = w->nuisance,
                             .nuisance_sigma = w->nuisance_sigma,
                             .ranking = w->ranking,
                             .nranking = 3};
  assert_ok(um_core_allocate(context, n, sizeof(double), &d->value_before));
  assert_ok(um_core_allocate(context, n, sizeof(double), &d->value_after));
  assert_ok(um_sensitivity_forward_evaluate(context, w->forward, NULL, 0, d->value_before));
  const struct um_model_addition all[] = {w->nuisance[0], w->addition[0], w->addition[1]};
  assert_ok(um_sensitivity_forward_evaluate(context, w->forward, all, 3, d->value_after));
  d->chi2 = chi2_of(w->forward, d->value_before);
  d->dof = (double)n;
  d->chi2_after = chi2_of(w->forward, d->value_after);
  d->dof_after = (double)n - 3.0;
  d->chi2_reduced = d->chi2 / d->dof;
  d->chi2_reduced_after = d->chi2_after / d->dof_after;
  w->alternative[0] = w->ranking[0];
  w->alternative[1] = w->ranking[1];
  w->alternative[1].indistinguishable = true;
  w->alternative[1].chi2 = NAN;
  w->alternative[1].excluded_by_prior = true;
  w->step[0] = (struct um_diagnosis_step){.candidate = 0,
                                          .addition = w->addition[0],
                                          .sigma = {0.7},
                                          .p_value = 1e-9,
                                          .delta_bic = -4990.0,
                                          .standing = UM_STANDING_ONE_OF_GROUP,
                                          .held_out_before = 5000.0,
                                          .held_out = 130.0,
                                          .chi2 = d->chi2_after,
                                          .dof = d->dof_after,
                                          .chi2_reduced = d->chi2_reduced_after,
                                          .nalternative = 2,
                                          .alternative = w->alternative};
  w->next[0] = (struct um_diagnosis_next){.what = what,
                                          .quantity = UM_QUANTITY_TEMPERATURE,
                                          .of = of,
                                          .segment = UM_SEGMENT_UMBRA,
                                          .airmass = NAN,
                                          .sigma = 0.3,
                                          .chi2_difference = 12.0,
                                          .from = w->forward->observations.t[0],
                                          .to = w->forward->observations.t[0] + 60.0,
                                          .candidate = 1};
  w->next[1] = (struct um_diagnosis_next){
      .airmass = NAN, .from = NAN, .to = NAN, .candidate = 2, .told_apart_by = "stars in frames"};
  d->nnext = 2;
  d->next_of = w->next;
  d->next = &w->next[0];
  w->superseded = (struct um_diagnosis_superseded){
      .addition = {effect_named("earth_ir_level"), NULL, {0.5}}, .sigma = {0.01}, .bic = 150.0};
  d->bic_after = 140.0;
  d->nsuperseded = 1;
  d->superseded = &w->superseded;
  d->allowance = true;
  d->residual = (struct um_missing_heat_residual){
      .channel = of, .coordinate = what, .p = 1e-4, .chi2_reduced = 7.5, .mean = -2.0};
  unexplained(w);
  d->unexplained = &w->unexplained;
}

static void world_end(struct world *w)
{
  um_core_free(context, w->d.value_before);
  um_core_free(context, w->d.value_after);
  um_sensitivity_forward_destroy(context, &w->forward);
  um_compare_measurements_destroy(context, &w->measurements);
  remove("m.csv");
}

/* ---- files ---- */

static const char *const files[] = {".umbra",   "diagnosis.json",         "ranking.csv", "fit.csv",
                                    "heat.csv", "improved/scenario.yaml", "plots.gp"};

static void remove_out(void)
{
  char path[64];
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
    snprintf(path, sizeof path, "out/%s", files[i]);
    remove(path);
  }
  remove("out/improved");
  assert_int_equal(rmdir("out"), 0);
}

/* Whatever gnuplot, where there is one, has drawn. */
static void remove_pictures(void)
{
  static const char *const kinds[] = {".png", ".svg", ".pdf"};
  char path[300];
  DIR *folder = opendir("out");
  assert_non_null(folder);
  for (struct dirent *entry; (entry = readdir(folder)) != NULL;)
    for (size_t k = 0; k < 3; k++) {
      if (strstr(entry->d_name, kinds[k]) == NULL) continue;
      snprintf(path, sizeof path, "out/%s", entry->d_name);
      remove(path);
    }
  closedir(folder);
}

static char *read_text(const char *path)
{
  char *text;
  size_t length;
  assert_ok(um_core_file_read(context, path, 1 << 22, &text, &length));
  return text;
}

static void write_out(struct world *w)
{
  struct um_core_folder *folder;
  assert_ok(um_core_folder_begin(context, "out", false, &folder));
  assert_ok(
      um_diagnosis_report_write(context, &w->d, "umbra diagnose\nscene m.csv", "9.9", folder));
  assert_ok(um_core_folder_commit(context, &folder));
}

static void expect_in(const char *text, const char *const *want, size_t n)
{
  for (size_t i = 0; i < n; i++)
    if (strstr(text, want[i]) == NULL) fail_msg("no %s in\n%s", want[i], text);
}

static void test_json(const char *path)
{
  static const char *const want[] = {
      "\"scenario\": \"pass\"",
      "\"verdict\": \"not_identifiable\"",
      "\"sentence\": \"Missing: \\\"power\\\"\\u000aand more.\"",
      "\"baseline\": {",
      "\"chi2_red\": ",
      "\"metrics\": [",
      "\"quantity\": \"temperature\", \"of\": \"bus.interior\", \"unit\": \"K\"",
      "\"unit\": \"mag\", \"residual_unit\": \"flux of magnitude 0\", \"all\": {\"count\": 1",
      "{\"effect\": \"internal_power\", \"target\": \"bus\", \"parameters\": [{",
      ("\"name\": \"power_W\", \"value\": 41.5, \"sigma\": 0.7, \"unit\": \"W\", \"whole\": {"
       "\"what\": \"power inside\", \"value\": 66.5, \"sigma\": 0.7, \"instead_of\": 25, "
       "\"unit\": \"W\"}}]"),
      /* 0.1 is what the scenario's effects state, beside nothing of the part */
      ("\"what\": \"electrical extraction\", \"value\": 0.1875, \"sigma\": 0.01, "
       "\"instead_of\": 0.1"),
      "\"standing\": \"one_of_group\"",
      "\"not_quite_noise\": true",
      "\"superseded\": [\n    {\"effect\": \"earth_ir_level\", \"target\": null",
      "\"what\": \"outgoing longwave radiation\", \"value\": 118.5",
      "\"bic_behind\": 10}",
      "\"residual\": {\"channel\": \"bus.+y\", \"chi2_red\": 7.5, \"mean_in_sigma\": -2",
      "\"excluded_by\": \"prior\"",
      "{\"effect\": \"internal_power:bus\", \"alternative\": \"emittance:grey_white\", \"what\"",
      "\"alternative\": \"time_tag\", \"what\": null, \"told_apart_by\": \"stars in frames\"}",
      "\"p_value\": 1e-09, \"delta_bic\": -4990, \"held_out\": {\"before\": 5000, \"after\": 130}",
      "\"indistinguishable_from\": [\"emittance:grey_white\"]",
      "\"next_measurement\": {\"what\": \"temperature of bus.+y in the umbra\"",
      "\"segment\": \"umbra\"",
      "\"unexplained\": {\"coordinate\": \"time_s\"",
      "\"part\": \"bus.interior\", \"start_utc\": \"2016-09-06T18:10:00.000Z\"",
      "\"energy_J\": 4400",
      "\"history\": [",
      "\"ranking\": [",
      "\"effect\": \"time_tag\", \"target\": null",
      "\"cost\": {\"candidates\": 3",
  };
  const char *where;
  char *text = read_text(path);
  if (!json_is_valid(text, &where)) fail_msg("not JSON from here on: %.80s", where);
  expect_in(text, want, sizeof want / sizeof want[0]);
  um_core_free(context, text);
}

/* Every row of the measurements, in their own unit; the residuals of both models square-sum to
 * their chi-squares. */
static void test_tables(const struct world *w)
{
  struct um_core_csv *csv;
  double sum[2] = {0.0, 0.0}, value;
  assert_ok(um_core_csv_read(context, "out/fit.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), w->forward->observations.count);
  for (size_t i = 0; i < um_core_csv_rows(csv); i++)
    for (size_t k = 0; k < 2; k++) {
      assert_ok(um_core_csv_number(context, csv, i, 7 + k, &value));
      sum[k] += value * value;
    }
  assert_close(sum[0], w->d.chi2, 1e-7 * w->d.chi2); /* nine digits are written */
  assert_close(sum[1], w->d.chi2_after, 1e-7 * w->d.chi2_after);
  size_t last = um_core_csv_rows(csv) - 1; /* the magnitude came last */
  assert_string_equal(um_core_csv_text(csv, last, 1), "magnitude_ab");
  assert_ok(um_core_csv_number(context, csv, last, 3, &value));
  assert_close(value, 5.5, 0.0);
  assert_ok(um_core_csv_number(context, csv, last, 4, &value));
  assert_close(value, 0.02, 0.0);
  assert_ok(um_core_csv_number(context, csv, last, 6, &value));
  assert_true(value > 0.0 && value < 15.0);
  um_core_csv_destroy(&csv);
  assert_ok(um_core_csv_read(context, "out/ranking.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), 3);
  assert_string_equal(um_core_csv_text(csv, 1, 1), "emittance");
  assert_string_equal(um_core_csv_text(csv, 1, 2), "grey_white");
  assert_string_equal(um_core_csv_text(csv, 2, 12), "tested");
  um_core_csv_destroy(&csv);
  assert_ok(um_core_csv_read(context, "out/heat.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), 40);
  assert_string_equal(um_core_csv_text(csv, 0, 0), "2016-09-06T18:08:00.000Z");
  assert_string_equal(um_core_csv_text(csv, 39, 1), "2016-09-06T18:14:00.000Z");
  um_core_csv_destroy(&csv);
}

static void test_files(void **state)
{
  (void)state;
  struct world w;
  world_make(&w);
  write_out(&w);
  test_json("out/diagnosis.json");
  test_tables(&w);
  remove_out();
  world_end(&w);
}

/* The text keeps what the user wrote; the changes of the command line and the effects stand in it;
 * the model that it makes says the same of every observation. */
static void test_improved(void **state)
{
  (void)state;
  static const char *const want[] = {
      "# Written by umbra 9.9: umbra diagnose scene m.csv\n",
      "# Verdict: not_identifiable. Missing: \"power\" and more.\n",
      " before, ",
      "# a box and a panel\n",
      "tle_file: ../../scene/orbit.tle # of the day",
      "mesh: ../../scene/panel.obj",
      "power_W: 25, conductance_W_K: 2",
      "  - {effect: panel_extraction, target: panel, efficiency: 0.1875} # guessed\n"
      "  - {effect: albedo, off: true}\n"
      "  - {effect: solar_absorptance, target: grey_white, absorptance_shift: 0.05",
      "  - {effect: internal_power, target: bus, power_W: 41.5}\n"
      "  - {effect: zero_point, target: lwir, factor: 1.0078125}\n"
      "measurements:\n",
  };
  struct world w;
  world_make(&w);
  write_out(&w);
  char *text = read_text("out/improved/scenario.yaml");
  expect_in(text, want, sizeof want / sizeof want[0]);
  um_core_free(context, text);
  struct um_sensitivity_forward *again;
  assert_ok(
      um_sensitivity_forward_create(context, "out/improved", NULL, w.measurements, 1.0, &again));
  double *value;
  assert_ok(um_core_allocate(context, again->observations.count, sizeof *value, &value));
  assert_ok(um_sensitivity_forward_evaluate(context, again, NULL, 0, value));
  for (size_t i = 0; i < again->observations.count;
       i++) /* effects come in another order: rounding */
    assert_close(value[i], w.d.value_after[i], 1e-9 * fabs(w.d.value_after[i]));
  um_core_free(context, value);
  um_sensitivity_forward_destroy(context, &again);
  remove_out();
  world_end(&w);
}

/* What pictures say of the verdict is what the verdict says: an effect that was not found is not
 * said to be, and what cannot be told apart stands side by side. */
static void test_titles(void **state)
{
  (void)state;
  struct world w;
  char text[200];
  world_make(&w);
  struct um_sensitivity_candidates *candidates = w.d.candidates;
  const struct {
    enum um_diagnosis_verdict verdict;
    size_t naddition;
    bool chosen, group;
    const char *says;
  } cases[] = {
      {UM_VERDICT_COMPLETE, 0, false, false, "complete, nothing added"},
      {UM_VERDICT_FOUND, 2, false, false,
       "found: internal_power of bus, panel_extraction of panel"},
      {UM_VERDICT_FOUND, 1, true, false, "fitted: internal_power of bus"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 1, false, true,
       "not identifiable: internal_power of bus (drawn) or emittance:grey_white"},
      {UM_VERDICT_NOT_IDENTIFIABLE, 0, false, false,
       "not identifiable, nothing added: a nuisance took it up"},
      {UM_VERDICT_UNEXPLAINED, 1, false, false, "unexplained, even with internal_power of bus"},
      {UM_VERDICT_UNEXPLAINED, 0, false, false, "unexplained, nothing added"},
      {UM_VERDICT_UNEXPLAINED, 1, true, false,
       "fitted, and not explained by: internal_power of bus"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    w.d.verdict = cases[i].verdict;
    w.d.naddition = cases[i].naddition;
    w.d.candidates = cases[i].chosen ? NULL : candidates;
    w.step[0].standing = cases[i].group ? UM_STANDING_ONE_OF_GROUP : UM_STANDING_CERTAIN;
    um_diagnosis_report_plot_verdict(&w.d, text, sizeof text);
    assert_string_equal(text, cases[i].says);
  }
  w.d.candidates = candidates;
  w.d.naddition = 2;
  w.d.verdict = UM_VERDICT_NOT_IDENTIFIABLE;
  w.step[0].standing = UM_STANDING_ONE_OF_GROUP;
  w.unexplained.found = false;
  write_out(&w);
  assert_ok(um_diagnosis_report_plot(context, &w.d, "out"));
  char *script = read_text("out/plots.gp");
  static const char *const want[] = {
      ("'not identifiable: internal_power of bus (drawn) or emittance:grey_white, "
       "panel_extraction of panel'"),
      "'pass: band irradiance lwir: rms ",
      "'explains a part at best: heat of bus.interior: best pulse 4400 ± 300 J'"};
  expect_in(script, want, sizeof want / sizeof want[0]);
  assert_null(strstr(script, "'with "));
  um_core_free(context, script);
  remove_pictures();
  remove_out();
  world_end(&w);
}

/* A mesh that has gone since: said in one line, nothing left. */
static void test_failure(void **state)
{
  (void)state;
  struct world w;
  struct um_core_folder *folder;
  world_make(&w);
  assert_int_equal(rename("scene", "gone"), 0);
  assert_ok(um_core_folder_begin(context, "out", false, &folder));
  um_core_message_clear(context);
  assert_int_equal(um_diagnosis_report_write(context, &w.d, "c", "v", folder), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "orbit.tle: No such file or directory");
  um_core_folder_abort(&folder);
  assert_int_equal(access("out", F_OK), -1);
  assert_int_equal(rename("gone", "scene"), 0);
  world_end(&w);
}

/* ---- requests ---- */

static void test_requests(void **state)
{
  (void)state;
  struct um_model *model;
  static const char *const nuisance[] = {"zero_point:vis,sigma=free", "time_tag,sigma=0.2,per=set",
                                         "zero_point:lwir"};
  static const char *const exclude[] = {"albedo"};
  static const char *const wanted[] = {"internal_power:bus,power_W=3", "area:panel"};
  const struct um_diagnosis_request_texts texts = {nuisance, exclude, wanted, 3, 1, 2};
  struct um_diagnosis_request r;
  assert_ok(um_model_create(context, "scene", NULL, &model));
  assert_ok(um_diagnosis_request_make(context, model, &texts, &r));
  /* the scenario's first, whose place the third text takes with the prior's own width */
  assert_int_equal(r.nnuisance, 3);
  assert_string_equal(r.nuisance[0].effect->name, "zero_point");
  assert_string_equal(r.nuisance[0].target, "lwir");
  assert_true(r.nuisance[0].sigma == r.nuisance[0].effect->parameters[0].prior_sigma);
  assert_true(isinf(r.nuisance[1].sigma));
  assert_true(r.nuisance[2].target == NULL && r.nuisance[2].sigma == 0.2);
  assert_string_equal(r.nuisance[2].per, "set");
  assert_int_equal(r.nexclude, 2);
  assert_string_equal(r.exclude[0], "time_tag");
  assert_string_equal(r.exclude[1], "albedo");
  assert_int_equal(r.nwanted, 2);
  assert_true(r.wanted[0].value[0] == 3.0);
  assert_true(isnan(r.wanted[1].value[0]));
  um_diagnosis_request_release(context, &r);
  static const struct {
    const char *nuisance, *wanted, *says;
  } refused[] = {
      {"gravity", NULL, "--nuisance gravity: no effect is called 'gravity'; accepted: "},
      {"zero_point:swir", NULL, "--nuisance zero_point:swir: nothing that 'zero_point' acts on"},
      {"zero_point:vis,sigma=-1", NULL, "sigma '-1'; accepted: a number above 0, or free"},
      {"zero_point:vis,width=1", NULL, "'width' is not known; accepted: sigma, per"},
      {"zero_point:vis,sigma", NULL, "'sigma' is not understood; accepted: NAME=VALUE"},
      {"albedo", NULL, "effect 'albedo' has no parameters to be uncertain of"},
      {NULL, "internal_power", "--add internal_power: effect 'internal_power' needs a target"},
      {NULL, "internal_power:bus,heat_W=1", "no parameter 'heat_W'; accepted: power_W"},
      {NULL, "internal_power:bus,power_W=x", "power_W 'x'; accepted: "},
  };
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    const struct um_diagnosis_request_texts one = {.nuisance = &refused[i].nuisance,
                                                   .nnuisance = refused[i].nuisance != NULL,
                                                   .wanted = &refused[i].wanted,
                                                   .nwanted = refused[i].wanted != NULL};
    um_core_message_clear(context);
    assert_int_equal(um_diagnosis_request_make(context, model, &one, &r), UM_ERR_INPUT);
    if (strstr(um_core_message(context), refused[i].says) == NULL)
      fail_msg("case %zu said: %s", i, um_core_message(context));
    um_diagnosis_request_release(context, &r);
  }
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_files), cmocka_unit_test(test_improved),
                                     cmocka_unit_test(test_titles), cmocka_unit_test(test_failure),
                                     cmocka_unit_test(test_requests)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
