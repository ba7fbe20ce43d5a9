/* A small satellite for the tests that need a model: a box with an interior and a panel, on the
 * pass of ENVISAT over Graz that begins in the umbra (rise 18:07:50, out of the umbra 18:10:05,
 * highest 18:14:3x). Lumped, with few bins: a run takes a fraction of a second. */
#ifndef UMBRA_TESTS_COMPARE_MODEL_H
#define UMBRA_TESTS_COMPARE_MODEL_H

#include "evidence/comparison/compare.h"
#include "evidence/inversion/synth.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/evidence/compare_test.h"

static const char *const scenario_text =
    "schema: 1\n"
    "name: pass\n"
    "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:20:00Z, step_s: 4}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude:\n"
    "  - spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 240}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "parts:\n"
    "  - name: bus\n"
    "    box: {size_m: [1, 1, 1]}\n"
    "    outside: grey_white\n"
    "    shell: {areal_heat_capacity_J_m2_K: 3000}\n"
    "    interior: {capacity_J_K: 4000, power_W: 20, conductance_W_K: 2}\n"
    "    lumped: true\n"
    "  - name: panel\n"
    "    plate: {size_m: [2, 1]}\n"
    "    pose: {position_m: [0, 3, 0]}\n"
    "    front: grey_panel\n"
    "    back: grey_metal\n"
    "    shell: {areal_heat_capacity_J_m2_K: 2000, through_conductance_W_m2_K: 50}\n"
    "    lumped: true\n"
    "thermal: {start: periodic, orbits_before: 1}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n";

#define SCENARIO "scenario.yaml"
#define HEAD     "time_utc,quantity,of,value,sigma\n"
#define DAY      "2016-09-06T18:"

static inline int model_set_up(void **state)
{
  if (compare_set_up(state) != 0) return -1;
  put(SCENARIO, scenario_text);
  return 0;
}

static inline int model_tear_down(void **state)
{
  remove(SCENARIO);
  remove("orbit.csv");
  return compare_tear_down(state);
}

/* A model and its own observations. */
struct world {
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
};

static inline struct um_model *model_of(const struct um_model_options *options)
{
  struct um_model *model;
  assert_ok(um_model_create(context, SCENARIO, options, &model));
  return model;
}

static inline struct world world_of(const struct um_model_options *options)
{
  struct world w = {.model = model_of(options)};
  assert_ok(um_model_precompute(context, w.model, &w.tables));
  assert_ok(um_model_run(context, w.model, w.tables, &w.result));
  return w;
}

static inline void world_end(struct world *w)
{
  um_model_result_destroy(context, &w->result);
  um_model_tables_destroy(context, &w->tables);
  um_model_destroy(context, &w->model);
}

/* Measurements beside a model, on geometry tables of their own times. */
struct pair {
  struct um_compare_measurements *measurements;
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_model_result *result;
  struct um_compare_comparison *comparison;
};

static inline struct pair pair_of(struct um_model *model, const char *path, double fitted)
{
  struct pair p = {0};
  assert_ok(um_compare_measurements_read(context, path, &p.measurements));
  assert_ok(um_compare_plan_create(context, model, p.measurements, &p.plan));
  assert_ok(um_compare_plan_trace(context, model, p.plan, &p.tables));
  assert_ok(um_model_run(context, model, p.tables, &p.result));
  struct um_compare_run run = {model, p.plan, p.tables, p.result};
  assert_ok(um_compare_create(context, &run, fitted, &p.comparison));
  return p;
}

static inline void pair_end(struct pair *p)
{
  um_compare_destroy(context, &p->comparison);
  um_model_result_destroy(context, &p->result);
  um_model_tables_destroy(context, &p->tables);
  um_compare_plan_destroy(context, &p->plan);
  um_compare_measurements_destroy(context, &p->measurements);
}

static inline const struct um_compare_channel_comparison *
channel_named(const struct um_compare_comparison *c, const char *of)
{
  for (size_t i = 0; i < c->nchannel; i++)
    if (strcmp(c->run.plan->measurements->channel[c->channel[i].channel].of, of) == 0)
      return &c->channel[i];
  fail_msg("no channel %s", of);
  return NULL;
}

#endif
