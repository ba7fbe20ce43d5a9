/* A diagnosis of that pass filled by hand, its folder written and removed: for tests of the files
 * and pictures of a report. */
#ifndef UMBRA_TESTS_DIAGNOSIS_REPORT_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_REPORT_TEST_H

#include <math.h>

#include "base/core/file.h"
#include "effects/effects.h"
#include "evidence/diagnosis/report/write.h"
#include "evidence/inversion/synth.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/write.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/evidence/diagnosis/pass_test.h"

static const char *const overrides[] = {"parts.bus.interior.power_W=25"};
static const char *const with[] = {"solar_absorptance:grey_white,shift=0.05"};
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
  double edge[41], history[40], history_sigma[40], history_low[40], history_high[40];
  struct um_diagnosis d;
};

static inline const struct um_effect *effect_named(const char *name)
{
  const struct um_effect *effect = um_effects_find(name);
  assert_non_null(effect);
  return effect;
}

/* Measurements of the scenario with more power inside, in both bands and of two places, by synth,
 * and one magnitude. */
static inline void measure(void)
{
  static const char *const hot[] = {"parts.bus.interior.power_W=25",
                                    "effects.panel_extraction:panel.efficiency=0.2"};
  static const char *const powered[] = {"solar_absorptance:grey_white,shift=0.05",
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
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_compare_measurements *made;
  assert_ok(um_model_create(context, "scene", &truth, &model));
  assert_ok(um_model_precompute(context, model, &tables));
  assert_ok(um_model_run(context, model, tables, &result));
  assert_ok(um_compare_synth_create(context, model, tables, result, &noise, "m.csv", &made));
  assert_ok(um_compare_measurements_write(context, made, "m.csv"));
  FILE *file = fopen("m.csv", "ab");
  assert_non_null(file);
  fputs("2016-09-06T18:14:00Z,magnitude_ab,vis,5.5,0.02\n", file);
  assert_int_equal(fclose(file), 0);
  um_compare_measurements_destroy(context, &made);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

static inline double chi2_of(const struct um_sensitivity_forward *f, const double *value)
{
  double sum = 0.0;
  for (size_t i = 0; i < f->observations.count; i++)
    sum += pow((f->observations.measured[i] - value[i]) / f->observations.sigma[i], 2.0);
  return sum;
}

static inline void candidate(struct world *w, size_t i, const char *effect, char *target,
                             char *name, double chi2, double estimate)
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

static inline void unexplained(struct world *w)
{
  double first = w->forward->observations.t[0];
  for (int i = 0; i <= 40; i++) w->edge[i] = first + 9.0 * i;
  for (int i = 0; i < 40; i++) {
    w->history[i] = 60.0 * exp(-pow((i - 18.0) / 5.0, 2.0)) + 3.0 * sin(2.3 * i);
    w->history_sigma[i] = 6.0;
    w->history_low[i] = w->history[i] - 12.0;
    w->history_high[i] = w->history[i] + 12.0;
  }
  static char place[] = "bus.interior", coordinate[] = "time_s", channel[] = "temperature bus";
  w->heat = (struct um_missing_heat){.place = place,
                                     .chi2_explained = 400.0,
                                     .course = {UM_HEAT_PULSE, first + 120.0, 80.0, NAN},
                                     .nparameter = 4,
                                     .stop = first + 200.0,
                                     .start_sigma = 4.0,
                                     .power = 55.0,
                                     .energy = 4400.0,
                                     .energy_sigma = 300.0,
                                     .nbin = 40,
                                     .t = w->edge,
                                     .heat = w->history,
                                     .sigma = w->history_sigma,
                                     .low = w->history_low,
                                     .high = w->history_high};
  w->unexplained = (struct um_missing_heat_unexplained){.coordinate = coordinate,
                                                        .channel = channel,
                                                        .p = 1e-5,
                                                        .nheat = 1,
                                                        .heat = &w->heat,
                                                        .chi2_before = 600.0,
                                                        .chi2_after = 200.0,
                                                        .found = true};
}

static inline void world_make(struct world *w)
{
  static char power[] = "internal_power:bus", mli[] = "emittance:grey_white", tag[] = "time_tag";
  static char bus[] = "bus", white[] = "grey_white", sentence[] = "Missing: \"power\"\nand more.";
  static char what[] = "temperature of bus.+y in the umbra", of[] = "bus.+y";
  *w = (struct world){0};
  measure();
  assert_ok(um_compare_measurements_read(context, "m.csv", &w->measurements));
  assert_ok(um_sensitivity_forward_create(context, "scene", &changes, w->measurements,
                                          UM_VARIANT_TIGHT, &w->forward));
  struct um_diagnosis *d = &w->d;
  size_t n = w->forward->observations.count;
  w->addition[0] = (struct um_model_addition){
      .effect = effect_named("internal_power"), .target = "bus", .value = {41.5}};
  w->addition[1] = (struct um_model_addition){
      .effect = effect_named("panel_extraction"), .target = "panel", .value = {0.1875}};
  w->nuisance[0] = (struct um_model_addition){
      .effect = effect_named("zero_point"), .target = "lwir", .value = {1.0078125}};
  w->addition_sigma[0][0] = 0.7;
  w->addition_sigma[1][0] = 0.01;
  w->nuisance_sigma[0][0] = 0.003;
  candidate(w, 0, "internal_power", bus, power, 5000.0, 40.0);
  candidate(w, 1, "emittance", white, mli, 4000.0, -0.1);
  candidate(w, 2, "time_tag", NULL, tag, 3.0, 0.2);
  w->candidates =
      (struct um_sensitivity_candidates){.count = 3, .nobservation = n, .candidate = w->candidate};
  *d = (struct um_diagnosis){.verdict = UM_VERDICT_NOT_IDENTIFIABLE,
                             .summary = sentence,
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
                                          .confidence = UM_CONFIDENCE_ONE_OF_GROUP,
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
                                          .cadence = 10.0,
                                          .phase_from = NAN,
                                          .from = w->forward->observations.t[0],
                                          .to = w->forward->observations.t[0] + 60.0,
                                          .candidate = 1};
  w->next[1] = (struct um_diagnosis_next){
      .airmass = NAN, .from = NAN, .to = NAN, .candidate = 2, .told_apart_by = "stars in frames"};
  d->nnext = 2;
  d->next_of = w->next;
  d->next = &w->next[0];
  w->superseded = (struct um_diagnosis_superseded){
      .addition = {.effect = effect_named("earth_ir_level"), .value = {0.5}},
      .sigma = {0.01},
      .bic = 150.0};
  d->bic_after = 140.0;
  d->nsuperseded = 1;
  d->superseded = &w->superseded;
  d->allowance = true;
  d->residual = (struct um_missing_heat_residual){
      .channel = of, .coordinate = what, .p = 1e-4, .chi2_reduced = 7.5, .mean = -2.0};
  unexplained(w);
  d->unexplained = &w->unexplained;
}

static inline void world_end(struct world *w)
{
  um_core_free(context, w->d.value_before);
  um_core_free(context, w->d.value_after);
  um_sensitivity_forward_destroy(context, &w->forward);
  um_compare_measurements_destroy(context, &w->measurements);
  remove("m.csv");
}

/* ---- its folder ---- */

static const char *const files[] = {
    ".umbra",   "diagnosis.json",         "diagnosis.txt", "ranking.csv", "fit.csv",
    "heat.csv", "improved/scenario.yaml", "plots.gp",      "report.html"};

static inline void remove_out(void)
{
  char path[64];
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
    snprintf(path, sizeof path, "out/%s", files[i]);
    remove(path);
  }
  remove("out/improved");
  assert_int_equal(rmdir("out"), 0);
}

static inline char *read_text(const char *path)
{
  char *text;
  size_t length;
  assert_ok(um_core_file_read(context, path, 1 << 22, &text, &length));
  return text;
}

static inline void write_out(struct world *w)
{
  struct um_core_folder *folder;
  assert_ok(um_core_folder_begin(context, "out", false, &folder));
  assert_ok(um_diagnosis_report_write(context, &w->d, "umbra diagnose\nscene m.csv", "9.9", false,
                                      folder));
  assert_ok(um_core_folder_commit(context, &folder));
}

static inline void expect_in(const char *text, const char *const *want, size_t n)
{
  for (size_t i = 0; i < n; i++)
    if (strstr(text, want[i]) == NULL) fail_msg("no %s in\n%s", want[i], text);
}

#endif
