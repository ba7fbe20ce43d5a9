/* A run goes on from the end of the orbit that is made periodic. Its audit has that orbit, too, and
 * places say how they change over it: against heat that is followed from the orbit's begin. */
#include <math.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "model/run/thermal_solution_group.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/hidden-effect/dusk"
#define REPEATS  0.02 /* what two orbits that repeat to 0.01 K may differ by [K] */

/* Orbits that begin within 0.01 K of each other radiate 1.3e-4 of it apart at most. */
static void close_to(const char *name, double value, double expected)
{
  print_message("%-10s %.6e J, followed %.6e J\n", name, value, expected);
  if (!(fabs(value - expected) <= 1e-4 * fabs(expected))) fail_msg("%s", name);
}

static void test_audit_and_drift(void **state)
{
  (void)state;
  static const char *const overrides[] = {"time.step_s=60", "time.exposure_s=0",
                                          "thermal.accuracy_K=0.01"};
  const struct um_model_options options = {.overrides = overrides, .noverride = 3};
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_thermal_solution *heat;
  struct um_model_result *result;
  struct um_thermal_history *h;
  assert_int_equal(um_model_create(context, SCENARIO, &options, &model), UM_OK);
  assert_int_equal(um_model_precompute(context, model, &tables), UM_OK);
  assert_int_equal(um_model_thermal_solution_create(context, model, tables, NULL, 1.0, &heat),
                   UM_OK);
  assert_int_equal(um_model_run_places(context, model, tables, heat, &result), UM_OK);
  assert_true(heat->run.from > tables->t_start + 0.5 * tables->period);
  const struct um_thermal_history *own = heat->run.history;
  size_t before = heat->run.before ? 1 : 0, ntime = own->ntime - before;
  assert_int_equal(um_thermal_solve(context, model->body->network, tables->loads,
                                    &heat->solver.options, heat->start, tables->t_start,
                                    own->t + before, ntime, &h),
                   UM_OK);
  close_to("solar", own->audit.solar, h->audit.solar);
  close_to("albedo", own->audit.albedo, h->audit.albedo);
  close_to("planet", own->audit.planet, h->audit.planet);
  close_to("radiated", own->audit.radiated, h->audit.radiated);
  assert_true(own->audit_error <= 1e-6 && own->audit_error >= 0.0);
  double worst = 0.0;
  for (size_t i = 0; i < h->nnode; i++)
    worst = fmax(worst, fabs(h->temperature[i] - own->temperature[before * h->nnode + i]));
  print_message("nodes at the first observation: %.2g K apart\n", worst);
  assert_true(worst <= REPEATS);
  for (size_t p = 0; p < model->body->nplace; p++) {
    assert_true(isfinite(result->place[p].drift));
    assert_true(fabs(result->place[p].drift) <= REPEATS);
  }
  um_thermal_history_destroy(context, &h);
  um_model_result_destroy(context, &result);
  um_model_thermal_solution_destroy(context, &heat);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_audit_and_drift)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
