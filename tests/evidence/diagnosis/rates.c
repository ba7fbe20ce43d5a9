/* A rate that does nothing while what goes on at it has not begun: the axis of a spinning body goes
 * about its angular momentum at a rate that the scenario has wrong, and the diagnosis names it with
 * tip and inertia ratio, in few evaluations; of a body that does not nutate it accuses nobody. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "evidence/diagnosis/diagnose.h"
#include "tests/evidence/diagnosis/measured_test.h"
#include "tests/support/cmocka_all.h"

static const char scenario[] =
    "schema: 1\n"
    "name: nodder\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:08:00Z, step_s: 8}\n"
    "orbit: {circular: {altitude_km: 600, beta_deg: 20, epoch_utc: 2020-03-20T12:10:00Z}}\n"
    "attitude: [{spin: {axis_gcrs: [0.3, -0.2, 1], axis_body: [0, 0, 1], period_s: 120,\n"
    "  at_utc: 2020-03-20T12:00:00Z}}]\n"
    "observer: {direction: {unit_gcrs: [0.5, 0.7, 0.1], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [1, 0.8, 1.2]}, outside: white_paint, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
    "  - {name: wing, plate: {size_m: [1.2, 1.4]}, pose: {position_m: [0, 1.5, 0],\n"
    "     rotation_deg: [0, 30, 0]}, front: grey_panel, back: white_paint, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 280, orbits_before: 0.02}\n"
    "optics: {samples: 256}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

#define TIP      -4.0 /* [deg] */
#define ACROSS   3.0
#define SHIFT    0.45
#define TIPPED   "nutation,tip_deg=-4,tip_across_deg=3,inertia_shift=0.45"
#define AFFORDED 40 /* evaluations: a scan of runs alone would take more */

static struct um_context *context;

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

struct diagnosed {
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  char path[64];
};

static void begin(const char *with, struct diagnosed *out)
{
  static const char *const only[] = {"nutation", "zero_point"};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = 2}, .no_next = true, .no_heat = true};
  const struct um_model_options changes = {.with = &with, .nwith = with == NULL ? 0 : 1};
  OK(um_core_context_create(NULL, &context));
  um_core_context_set_threads(context, 1); /* too small to share */
  snprintf(out->path, sizeof out->path, "rates_%ld.yaml", (long)getpid());
  FILE *file = fopen(out->path, "w");
  assert_non_null(file);
  fputs(scenario, file);
  assert_int_equal(fclose(file), 0);
  measured_make(context, out->path, &changes, &out->measured);
  OK(um_sensitivity_forward_create(context, out->path, NULL, out->measured, UM_VARIANT_TIGHT,
                                   &out->forward));
  OK(um_sensitivity_candidates_create(context, out->forward, NULL, 0, &options.candidates,
                                      &out->candidates));
  OK(um_diagnosis_create(context, out->forward, out->candidates, &options, &out->d));
  print_message("  %s\n  %zu evaluations, %.3g s\n", out->d->summary, out->forward->evaluations,
                out->forward->seconds);
}

static void end(struct diagnosed *x)
{
  um_diagnosis_destroy(context, &x->d);
  um_sensitivity_candidates_destroy(context, &x->candidates);
  um_sensitivity_forward_destroy(context, &x->forward);
  um_compare_measurements_destroy(context, &x->measured);
  um_core_context_destroy(&context);
  remove(x->path);
}

static void rate_is_found(void **state)
{
  static const double expected[] = {TIP, ACROSS, SHIFT};
  struct diagnosed x = {.measured = NULL};
  (void)state;
  begin(TIPPED, &x);
  const struct um_sensitivity_candidate *c = &x.candidates->candidate[0];
  assert_string_equal(c->name, "nutation");
  assert_int_equal(c->ncolumn, 2);
  assert_int_equal(c->nunidentified, 1);
  assert_true(c->trials > 17); /* those of the even spacing, and between them */
  assert_true(fabs(c->null_value[2] - SHIFT) < 0.05); /* by small turns alone */
  assert_int_equal(x.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(x.d->naddition, 1);
  assert_string_equal(x.d->addition[0].effect->name, "nutation");
  for (size_t p = 0; p < 3; p++)
    assert_true(fabs(x.d->addition[0].value[p] - expected[p]) <= 3.0 * x.d->addition_sigma[0][p]);
  assert_true(x.forward->evaluations <= AFFORDED);
  end(&x);
}

/* The best of many rates is no evidence: that so many were tried is counted. */
static void noise_is_not_accused(void **state)
{
  struct diagnosed x = {.measured = NULL};
  (void)state;
  begin(NULL, &x);
  assert_true(x.candidates->candidate[0].trials > 10);
  assert_int_equal(x.d->verdict, UM_VERDICT_COMPLETE);
  for (size_t i = 0; i < x.d->nranking; i++) assert_true(x.d->ranking[i].score.p_corrected > 0.01);
  end(&x);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(rate_is_found),
                                     cmocka_unit_test(noise_is_not_accused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
