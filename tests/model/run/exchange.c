/* What surfaces absorb of each other is taken at temperatures that the start gives: of a stated
 * start those of the run, of a periodic one those of its orbit, as settled as its state; variants
 * of a model begin with the model's. */
#include <math.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/thermal_solution.h"
#include "model/run/thermal_solution_group.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"
#include "thermal/exchange/exchange_group.h"

#define ELBOW UMBRA_SOURCE_DIR "/tests/scenarios/data/elbow"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s", um_core_message(context));                                 \
  } while (0)

struct run {
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_thermal_solution *heat;
};

static void compute(const char *const *overrides, size_t noverride, struct run *run)
{
  const struct um_model_options options = {.overrides = overrides, .noverride = noverride};
  *run = (struct run){0};
  OK(um_model_create(context, ELBOW, &options, &run->model));
  OK(um_model_precompute(context, run->model, &run->tables));
  OK(um_model_thermal_solution_create(context, run->model, run->tables, NULL, 1.0, &run->heat));
}

static void release(struct run *run)
{
  um_model_thermal_solution_destroy(context, &run->heat);
  um_model_tables_destroy(context, &run->tables);
  um_model_destroy(context, &run->model);
}

/* From 230 K through half an hour: means of that, found again here. */
static void stated_start(void **state)
{
  (void)state;
  static const char *const set[] = {"parts.array.front=mli_kapton", "thermal.start=isothermal",
                                    "thermal.start_temperature_K=230", "thermal.orbits_before=0.3"};
  struct run run;
  double change = NAN;
  compute(set, 4, &run);
  struct um_thermal_exchange *x = run.heat->solver.exchange;
  struct um_thermal_network *network = run.model->body->network;
  struct um_thermal_history *h = NULL;
  size_t n = um_thermal_network_nodes(network);
  double *mean = test_calloc(n, sizeof *mean), time[200];
  const struct um_irradiation_loads *loads = run.tables->loads;
  double from = run.tables->t_start, to = loads->t[loads->ntime - 1];
  assert_true(to - from > 1800.0);
  for (int k = 0; k < 200; k++) time[k] = from + (to - from) * k / 199;
  OK(um_thermal_solve(context, network, loads, &run.heat->solver.options, run.heat->start, from,
                      time, 200, &h));
  for (int k = 0; k < 200; k++)
    for (size_t i = 0; i < n; i++) mean[i] += h->temperature[(size_t)k * n + i] / 200;
  um_thermal_history_destroy(context, &h);
  OK(um_thermal_exchange_renew(context, network, run.tables->view_factors, NULL, mean, 0.0, x,
                               &change));
  print_message("stated start: an emittance moves by %.1e\n", change);
  assert_true(change > 0.0 && change < 2e-3);
  test_free(mean);
  release(&run);
}

static void periodic_start(void **state)
{
  (void)state;
  static const char *const set[] = {"parts.array.front=mli_kapton"};
  struct run run;
  struct um_model_thermal_solution *again = NULL;
  struct um_thermal_periodic report;
  double change = NAN;
  compute(set, 1, &run);
  struct um_thermal_network *network = run.model->body->network;
  struct um_thermal_exchange *x = run.heat->solver.exchange;
  size_t n = um_thermal_network_nodes(network);
  double *mean = test_calloc(n, sizeof *mean), *end = test_calloc(n, sizeof *end);
  OK(um_thermal_solve_periodic_report(
      context, network, run.tables->loads, &run.heat->solver.options, run.heat->start,
      run.tables->t_start, run.tables->period, 0.01, end, NULL, mean, &report));
  /* variants begin with what is settled, bit for bit, and stay with it where nothing moves */
  OK(um_model_thermal_solution_create(context, run.model, run.tables, run.heat, 1.0, &again));
  for (size_t s = 0; s < x->nsurface; s++)
    assert_true(again->solver.exchange->arriving[s] == x->arriving[s]);
  um_model_thermal_solution_destroy(context, &again);
  OK(um_thermal_exchange_renew(context, network, run.tables->view_factors, NULL, mean, 0.0, x,
                               &change));
  print_message("periodic start: an emittance moves by %.1e\n", change);
  assert_true(change > 0.0 && change <= 1.1 * UM_MODEL_SAME_EMITTANCE);
  test_free(mean);
  test_free(end);
  release(&run);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(stated_start),
      cmocka_unit_test(periodic_start),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
