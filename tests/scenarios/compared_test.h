/* A scenario before measurements of one channel: the metrics of all its rows. */
#ifndef UMBRA_TESTS_SCENARIOS_COMPARED_TEST_H
#define UMBRA_TESTS_SCENARIOS_COMPARED_TEST_H

#include "evidence/comparison/compare.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "model/run/run.h"
#include "tests/scenarios/support.h"

static inline void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

static inline struct um_compare_metrics compared(const char *scenario, const char *measurements,
                                                 const struct um_model_options *options)
{
  struct um_context *context = NULL;
  struct um_compare_measurements *measured = NULL;
  struct um_compare_plan *plan = NULL;
  struct um_compare_comparison *comparison = NULL;
  struct support_run run = {0};
  need(NULL, um_core_context_create(NULL, &context));
  need(context, um_compare_measurements_read(context, measurements, &measured));
  need(context, um_model_create(context, scenario, options, &run.model));
  need(context, um_compare_plan_create(context, run.model, measured, &plan));
  need(context, um_compare_plan_trace(context, run.model, plan, &run.tables));
  need(context, um_model_run(context, run.model, run.tables, &run.result));
  const struct um_compare_run whole = {run.model, plan, run.tables, run.result};
  need(context, um_compare_create(context, &whole, 0.0, &comparison));
  assert_int_equal(comparison->nchannel, 1);
  struct um_compare_metrics metrics = comparison->channel[0].all;
  um_compare_destroy(context, &comparison);
  um_model_result_destroy(context, &run.result);
  um_model_tables_destroy(context, &run.tables);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &run.model);
  um_compare_measurements_destroy(context, &measured);
  um_core_context_destroy(&context);
  return metrics;
}

#endif
