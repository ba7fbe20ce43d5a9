/* A scenario beside measurements, compared. */
#ifndef UMBRA_TESTS_COMPARE_COMPARED_H
#define UMBRA_TESTS_COMPARE_COMPARED_H

#include "compare_test.h"
#include "evidence/comparison/compare.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"

#define SCENARIO "scenario.yaml"

static inline struct um_model *model_with(const char *override)
{
  struct um_model *model;
  struct um_model_options options = {.overrides = &override, .noverride = override != NULL};
  assert_ok(um_model_create(context, SCENARIO, &options, &model));
  return model;
}

struct compared {
  struct um_compare_measurements *measurements;
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_compare_comparison *comparison;
};

static inline struct compared compare(struct um_model *model, const char *rows)
{
  struct compared p = {0};
  put("m.csv", rows);
  assert_ok(um_compare_measurements_read(context, "m.csv", &p.measurements));
  assert_ok(um_compare_plan_create(context, model, p.measurements, &p.plan));
  assert_ok(um_compare_plan_trace(context, model, p.plan, &p.tables));
  assert_ok(um_model_run(context, model, p.tables, &p.result));
  struct um_compare_run run = {model, p.plan, p.tables, p.result};
  assert_ok(um_compare_create(context, &run, 0.0, &p.comparison));
  return p;
}

static inline void compared_end(struct compared *p)
{
  um_compare_destroy(context, &p->comparison);
  um_model_result_destroy(context, &p->result);
  um_model_tables_destroy(context, &p->tables);
  um_compare_plan_destroy(context, &p->plan);
  um_compare_measurements_destroy(context, &p->measurements);
}

#endif
