/* An effect on everything, one parameter of which does nothing: a plate turned about its own normal
 * looks as before, so the offset of the attitude has two angles to fit and one that is searched in
 * vain. It is named all the same, its two angles within three of their sigmas. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "evidence/diagnosis/diagnose.h"
#include "tests/evidence/diagnosis/measured_test.h"
#include "tests/support/cmocka_all.h"

static const char scenario[] =
    "schema: 1\n"
    "name: turner\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:12:00Z, step_s: 36}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20, epoch_utc: 2020-03-20T12:10:00Z}}\n"
    "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0.6, 0.8], period_s: 700,\n"
    "  at_utc: 2020-03-20T12:01:00Z}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, front: grey_panel, back: white_paint, lumped: "
    "true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 280, orbits_before: 0.02}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

#define TURNED_X 3.0 /* [deg] */
#define TURNED_Y -2.0

static struct um_context *context;

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static void parameter_that_does_nothing(void **state)
{
  (void)state;
  static const char *const only[] = {"attitude_offset", "zero_point"};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = 2}, .no_next = true, .no_heat = true};
  static const char *const with = "attitude_offset,x_deg=3,y_deg=-2";
  const struct um_model_options changes = {.with = &with, .nwith = 1};
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  char path[64];
  OK(um_core_context_create(NULL, &context));
  um_core_context_set_threads(context, 1); /* too small to share */
  snprintf(path, sizeof path, "shape_%ld.yaml", (long)getpid());
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(scenario, file);
  assert_int_equal(fclose(file), 0);
  measured_make(context, path, &changes, &measured);
  OK(um_sensitivity_forward_create(context, path, NULL, measured, UM_VARIANT_TIGHT, &forward));
  OK(um_sensitivity_candidates_create(context, forward, NULL, 0, &options.candidates, &candidates));
  const struct um_sensitivity_candidate *c = &candidates->candidate[0];
  assert_string_equal(c->name, "attitude_offset");
  assert_int_equal(c->ncolumn, 2);
  assert_int_equal(c->nunidentified, 1);
  OK(um_diagnosis_create(context, forward, candidates, &options, &d));
  print_message("  %s\n  %zu evaluations, %.3g s\n", d->summary, forward->evaluations,
                forward->seconds);
  assert_true(d->naddition >= 1);
  assert_string_equal(d->addition[0].effect->name, "attitude_offset");
  assert_true(fabs(d->addition[0].value[0] - TURNED_X) <= 3.0 * d->addition_sigma[0][0]);
  assert_true(fabs(d->addition[0].value[1] - TURNED_Y) <= 3.0 * d->addition_sigma[0][1]);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &forward);
  um_compare_measurements_destroy(context, &measured);
  um_core_context_destroy(&context);
  remove(path);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(parameter_that_does_nothing)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
