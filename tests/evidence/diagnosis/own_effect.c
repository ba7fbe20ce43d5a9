/* An effect of a user's own is a candidate like any other: measurements made with it, in a detector
 * whose bright end is compressed by a fifth, are read with it hidden, and the diagnosis names it
 * before its alternatives, with a value within three of its sigmas. OBJECT is the worked example.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "evidence/diagnosis/diagnose.h"
#include "evidence/inversion/synth.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

/* A spinning plate in sunlight, seen in glints and out of them. */
static const char scenario[] =
    "schema: 1\n"
    "name: spinner\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:12:00Z, step_s: 12}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20, epoch_utc: 2020-03-20T12:10:00Z}}\n"
    "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0.6, 0.8], period_s: 700,\n"
    "  at_utc: 2020-03-20T12:01:00Z}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, pose: {rotation_deg: [0, 60, 0]},\n"
    "     front: grey_panel, back: white_paint, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 280, orbits_before: 0.02}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static const char *const files[] = {OBJECT};

/* Brightest visible irradiance of the scenario [W/m^2], and measurements of it with effects. */
static double measure(const char *path, const char *with, const struct um_compare_synth *noise,
                      struct um_compare_measurements **out)
{
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_model_options options = {.effect_files = files, .neffect_file = 1};
  double largest = 0.0;
  options.with = &with;
  options.nwith = with != NULL;
  OK(um_model_create(context, path, &options, &model));
  OK(um_model_precompute(context, model, &tables));
  OK(um_model_run(context, model, tables, &result));
  for (size_t k = 0; k < result->nobs; k++) largest = fmax(largest, result->irradiance[2 * k]);
  if (out != NULL) OK(um_compare_synth_create(context, model, tables, result, noise, "made", out));
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return largest;
}

static void own_effect_is_named(void **state)
{
  (void)state;
  static const char *const only[] = {"pileup",   "zero_point",     "background", "roughness",
                                     "exposure", "specular_level", "time_tag"};
  const struct um_compare_synth noise = {.relative = 0.01, .floor = 0.001, .seed = 7};
  const struct um_model_options changes = {.effect_files = files, .neffect_file = 1};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = sizeof only / sizeof only[0]},
      .no_next = true,
      .no_heat = true};
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  char path[64], with[64];
  snprintf(path, sizeof path, "own_effect_%ld.yaml", (long)getpid());
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(scenario, file);
  assert_int_equal(fclose(file), 0);
  double q = -0.2 / measure(path, NULL, NULL, NULL);
  snprintf(with, sizeof with, "pileup:vis,q_m2_W=%.17g", q);
  measure(path, with, &noise, &measured);
  OK(um_sensitivity_forward_create(context, path, &changes, measured, UM_VARIANT_TIGHT, &forward));
  OK(um_sensitivity_candidates_create(context, forward, NULL, 0, &options.candidates, &candidates));
  OK(um_diagnosis_create(context, forward, candidates, &options, &d));
  print_message("  %s\n", d->summary);
  assert_int_equal(d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(d->naddition, 1);
  assert_string_equal(d->addition[0].effect->name, "pileup");
  assert_string_equal(d->addition[0].target, "vis");
  double away = (d->addition[0].value[0] - q) / d->addition_sigma[0][0];
  print_message("  q %.4g +- %.2g, true %.4g m^2/W; reduced chi-square %.3f before, %.3f after\n",
                d->addition[0].value[0], d->addition_sigma[0][0], q, d->chi2_reduced,
                d->chi2_reduced_after);
  assert_true(fabs(away) <= 3.0);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &forward);
  um_compare_measurements_destroy(context, &measured);
  remove(path);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(own_effect_is_named)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
