/* Points of a study against runs of their own: `umbra run` with --set and --with, cold, with the
 * scenario's tolerances and geometry. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "study/study_impl.h"
#include "tests/study/world.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define PARAMETERS                                                                                 \
  "parameters:\n"                                                                                  \
  "  - {material: grey_panel, property: emittance, from: 0.6, to: 0.9}\n"                          \
  "  - {key: parts.box.interior.power_W, from: 0, to: 100}\n"                                      \
  "  - {material: grey_white, property: absorptance, from: 0.15, to: 0.3}\n"
#define OUTPUTS "outputs: {bands: [vis, lwir], places: [box, wing.front]}\n"

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static void release(struct um_study **study, struct um_study_result **result)
{
  um_study_result_destroy(context, result);
  um_study_destroy(context, study);
}

/* A run of its own of a point; curves as the study has them, [4][ntime]. */
static void own_run(const char *set, const char *const with[2], double *value, size_t ntime)
{
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *r = NULL;
  const struct um_model_options options = {
      .overrides = &set, .noverride = 1, .with = with, .nwith = 2};
  need(um_model_create(context, WORLD_SCENARIO, &options, &model));
  need(um_model_precompute(context, model, &tables));
  need(um_model_run(context, model, tables, &r));
  assert_int_equal(r->nobs, ntime);
  for (size_t k = 0; k < ntime; k++) {
    value[k] = r->irradiance[2 * k];
    value[ntime + k] = r->irradiance[2 * k + 1];
    for (size_t p = 0; p < r->nplace; p++) {
      if (strcmp(r->place[p].name, "box") == 0) value[2 * ntime + k] = r->place[p].mean[k];
      if (strcmp(r->place[p].name, "wing.front") == 0) value[3 * ntime + k] = r->place[p].mean[k];
    }
  }
  um_model_result_destroy(context, &r);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

/* Largest difference from runs of their own over the asked error, at every `stride`-th point. */
static double against_own_runs(const struct um_study_result *r, size_t stride)
{
  double worst = 0.0, *own = malloc(r->nvalue * sizeof *own);
  const double emittance = 0.85, absorptance = 0.2; /* grey_panel, grey_white: their records */
  for (size_t i = 0; i < r->npoint; i += stride) {
    const double *x = r->parameter + i * 3;
    char set[100], emits[100], absorbs[100];
    const char *const with[2] = {emits, absorbs};
    snprintf(set, sizeof set, "parts.box.interior.power_W=%.17g", x[1]);
    snprintf(emits, sizeof emits, "emittance:grey_panel,factor=%.17g", x[0] / emittance);
    snprintf(absorbs, sizeof absorbs, "solar_absorptance:grey_white,shift=%.17g",
             x[2] - absorptance);
    own_run(set, with, own, r->ntime);
    for (size_t q = 0; q < 4; q++) {
      double largest = 0.0;
      for (size_t k = 0; k < r->ntime; k++) largest = fmax(largest, fabs(own[q * r->ntime + k]));
      for (size_t k = 0; k < r->ntime; k++) {
        size_t at = q * r->ntime + k;
        double unit = q < 2 ? 1e-3 * fmax(fabs(own[at]), UM_STUDY_FLOOR * largest) : 0.1;
        if (unit > 0.0) worst = fmax(worst, fabs(r->value[i * r->nvalue + at] - own[at]) / unit);
      }
    }
  }
  free(own);
  return worst;
}

static void test_exact(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  world_clear(context);
  struct um_study_result *r =
      world_run(context, PARAMETERS OUTPUTS "design: {kind: latin_hypercube, points: 6, seed: 3}\n",
                1, false, &study);
  assert_int_equal(r->npoint, 6);
  assert_int_equal(r->nvalue, 4 * r->ntime);
  assert_true(fabs(r->at_nominal[0] - 0.85) < 1e-9);
  assert_true(r->at_nominal[1] == 5.0); /* as the scenario's text has it */
  double worst = against_own_runs(r, 3);
  print_message("exact: %.3f of the asked error\n", worst);
  assert_true(worst > 0.0 && worst <= 1.0);
  for (size_t q = 0; q < 4; q++) assert_true(r->error[q] <= (q < 2 ? 1e-3 : 0.1));
  /* a second study takes the points from the records, to the bit */
  struct um_study *again = NULL;
  struct um_study_result *s =
      world_run(context, PARAMETERS OUTPUTS "design: {kind: latin_hypercube, points: 6, seed: 3}\n",
                1, true, &again);
  assert_memory_equal(r->value, s->value, r->npoint * r->nvalue * sizeof(double));
  release(&again, &s);
  release(&study, &r);
  world_clear(context);
}

/* Loose tolerances warm or cool every point alike: what they do to the scenario is corrected, and a
 * point of a thousandfold tolerances is twice as near to its own light and temperatures or nearer.
 */
static void test_bias_correction(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  struct um_variant variant;
  const struct um_study_run_options options = world_options(1, false);
  const double parameter[3] = {0.7, 60.0, 0.25};
  double off[2][4], *known;
  world_clear(context);
  world_put(PARAMETERS OUTPUTS "design: {kind: latin_hypercube, points: 6, seed: 3}\n");
  need(um_study_create(context, WORLD_STUDY, &options, &study));
  study->accuracy.tolerance = (struct um_variant_tolerance){1000.0, 0.01};
  need(um_variant_accuracy_bias(context, &study->curves, &study->accuracy));
  double *value = malloc(2 * study->nvalue * sizeof *value), *own = value + study->nvalue;
  assert_non_null(value);
  need(um_study_open(context, study, study->binding, study->nbinding, parameter, &variant));
  need(um_variant_values(context, &study->curves, NULL, &variant, own));
  known = study->accuracy.correction;
  for (int taken = 0; taken < 2; taken++) {
    study->accuracy.correction = taken ? known : NULL;
    need(um_variant_values(context, &study->curves, &study->accuracy, &variant, value));
    um_variant_differences(&study->curves, value, own, off[taken]);
  }
  for (size_t q = 1; q < 4; q++) {
    print_message("loose: %.3g off, %.3g corrected, %.3g left\n", off[0][q],
                  study->accuracy.bias[q], off[1][q]);
    assert_true(study->accuracy.bias[q] > 0.0 && off[1][q] < 0.5 * off[0][q]);
  }
  free(value);
  um_variant_close(context, &variant);
  um_study_destroy(context, &study);
  world_clear(context);
}

/* Any order and any number of processes give the same bits. */
static void test_any_process(void **state)
{
  (void)state;
  struct um_study *a = NULL, *b = NULL;
  static const char text[] = "parameters:\n"
                             "  - {material: grey_panel, property: emittance, from: 0.6, to: 0.9}\n"
                             "  - {key: orbit.circular.beta_deg, values: [20, 25]}\n" OUTPUTS
                             "design: {kind: grid, levels: 2}\n";
  world_clear(context);
  struct um_study_result *one = world_run(context, text, 1, false, &a);
  world_clear(context);
  struct um_study_result *two = world_run(context, text, 2, false, &b);
  assert_int_equal(one->npoint, 4);
  assert_memory_equal(one->value, two->value, one->npoint * one->nvalue * sizeof(double));
  /* beta_deg is the last axis and moves the geometry: its neighbours differ */
  assert_true(one->value[0] != one->value[one->nvalue]);
  release(&a, &one);
  release(&b, &two);
  world_clear(context);
}

static void test_surrogate(void **state)
{
  (void)state;
  struct um_study *study = NULL;
  world_clear(context);
  struct um_study_result *r = world_run(context,
                                        "mode: surrogate\n" PARAMETERS OUTPUTS
                                        "design: {kind: sobol, points: 500, seed: 7}\n",
                                        2, false, &study);
  assert_int_equal(r->npoint, 500);
  assert_true(r->exact < 100);
  double worst = against_own_runs(r, 100);
  print_message("surrogate of %zu points: %.3f of the asked error\n", r->exact, worst);
  assert_true(worst <= 1.0);
  release(&study, &r);
  world_clear(context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_exact), cmocka_unit_test(test_bias_correction),
      cmocka_unit_test(test_any_process), cmocka_unit_test(test_surrogate)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
