/* scenarios/delfi-pq before its telemetry: as its builders described it the panels' swing is three
 * times too large. One number, found in the first week, takes nine tenths of the error away in the
 * second, which had no say. Figures are those of README.md, to half of their last digit and 1 mK.
 */
#include "evidence/comparison/compare.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "model/run/run.h"
#include "tests/scenarios/support.h"

#define FOLDER UMBRA_SOURCE_DIR "/scenarios/delfi-pq/"
#define FOUND  "heat_capacity:body,factor=2.252"

static void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

/* Residual of the mean of the long panels. */
static struct um_compare_metrics compute(const char *scenario, const char *measurements,
                                         const char *with)
{
  struct um_context *context = NULL;
  struct um_compare_measurements *measured = NULL;
  struct um_compare_plan *plan = NULL;
  struct um_compare_comparison *comparison = NULL;
  struct support_run run = {0};
  const struct um_model_options options = {.with = &with, .nwith = with != NULL};
  need(NULL, um_core_context_create(NULL, &context));
  need(context, um_compare_measurements_read(context, measurements, &measured));
  need(context, um_model_create(context, scenario, &options, &run.model));
  need(context, um_compare_plan_create(context, run.model, measured, &plan));
  need(context, um_compare_plan_trace(context, run.model, plan, &run.tables));
  need(context, um_model_run(context, run.model, run.tables, &run.result));
  const struct um_compare_run compared = {run.model, plan, run.tables, run.result};
  need(context, um_compare_create(context, &compared, 0.0, &comparison));
  assert_int_equal(comparison->nchannel, 1);
  struct um_compare_metrics metrics = comparison->channel[0].all;
  um_compare_destroy(context, &comparison);
  um_model_result_destroy(context, &run.result);
  um_model_tables_destroy(context, &run.tables);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &run.model);
  um_compare_measurements_destroy(context, &measured);
  um_core_context_destroy(&context);
  print_message("%s: %zu rows, bias %+.2f, rms %.2f K\n", with == NULL ? "as designed" : with,
                metrics.count, metrics.bias, metrics.rms);
  return metrics;
}

static void one_number_carries_over(void **state)
{
  (void)state;
  static const struct {
    const char *scenario, *measured, *with;
    size_t rows;
    double rms;
  } cases[] = {
      {FOLDER "scenario.yaml", FOLDER "measured-2022-02-03.csv", NULL, 78, 11.89},
      {FOLDER "scenario.yaml", FOLDER "measured-2022-02-03.csv", FOUND, 78, 2.06},
      {FOLDER "second.yaml", FOLDER "measured-2022-02-08.csv", NULL, 121, 11.05},
      {FOLDER "second.yaml", FOLDER "measured-2022-02-08.csv", FOUND, 121, 1.28},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    struct um_compare_metrics m = compute(cases[i].scenario, cases[i].measured, cases[i].with);
    assert_int_equal(m.count, cases[i].rows);
    support_close("rms [K]", m.rms, cases[i].rms, 0.006);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_number_carries_over)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
