/* Two passes a day apart of a box with a slow inside: scenario, rows of either pass
 * and a truth with noise, for tests of several sets of measurements. */
#ifndef UMBRA_TESTS_DIAGNOSIS_SETS_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_SETS_TEST_H

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/core/sampling.h"
#include "evidence/comparison/predict.h"
#include "evidence/measurements/join.h"
#include "evidence/measurements/make.h"
#include "model/build/build.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"

static const char scenario[] =
    "schema: 1\n"
    "name: box\n"
    "time: {start_utc: 2026-03-01T00:00:00Z, stop_utc: 2026-03-02T00:10:00Z, step_s: 60}\n"
    "orbit: {circular: {altitude_km: 700, beta_deg: 35, epoch_utc: 2026-03-01T00:00:00Z}}\n"
    "attitude: [{lvlh: {}}]\n"
    "observer: {direction: {unit_gcrs: [0.4, 0.8, 0.45], range_km: 1000}}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [0.5, 0.4, 0.6]}, outside: white_paint, lumped: true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 4000},\n"
    "     interior: {capacity_J_K: 60000, power_W: 15, conductance_W_K: 1.2}}\n"
    "thermal: {start: periodic, orbits_before: 1}\n"
    "bands:\n"
    "  vis: {from_um: 0.4, to_um: 0.8, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

#define ROWS  20      /* of a pass and band */
#define STEP  30.0    /* [s] */
#define APART 86400.0 /* of the passes [s] */
#define SIGMA 0.01    /* of a value */

static struct um_context *context;
static char path[64]; /* of the scenario */

#define OK(call)                                                                                   \
  do {                                                                                             \
    um_core_message_clear(context);                                                                \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static inline int set_up(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  um_core_context_set_threads(context, 1); /* too small to share */
  snprintf(path, sizeof path, "box_%ld.yaml", (long)getpid());
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  return fclose(file);
}

static inline int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return remove(path);
}

/* Rows of a pass as they are before they have values. */
static inline void rows_of(double start, double since, struct um_compare_measurements **out)
{
  struct um_compare_row row[2 * ROWS];
  for (size_t i = 0; i < 2 * ROWS; i++)
    row[i] = (struct um_compare_row){.t_tai = start + since + STEP * (double)(i / 2),
                                     .quantity = "band_irradiance",
                                     .of = i % 2 == 0 ? "vis" : "lwir",
                                     .value = 1.0,
                                     .sigma = 1.0,
                                     .exposure = NAN,
                                     .satellite_height = NAN,
                                     .azimuth = NAN,
                                     .elevation = NAN};
  OK(um_compare_measurements_make(context, since > 0.0 ? "late" : "early", row, 2 * ROWS, out));
}

/* A normal deviate of mean 0 and sigma 1 by Box and Muller, repeatable. */
static inline double noise_of(size_t i)
{
  double u = ((double)(um_core_hash(77, 2 * i) >> 11) + 0.5) / 9007199254740992.0;
  double v = ((double)(um_core_hash(77, 2 * i + 1) >> 11) + 0.5) / 9007199254740992.0;
  return sqrt(-2.0 * log(u)) * cos(6.283185307179586 * v);
}

/* Give rows the values of the scenario with an effect, NULL: as it stands, and noise. */
static inline void measure(const char *with, struct um_compare_measurements *m)
{
  const struct um_model_options options = {.with = &with, .nwith = with != NULL};
  struct um_model *model;
  struct um_compare_plan *plan;
  struct um_model_tables *tables;
  struct um_model_result *result;
  double *value, largest[2] = {0.0, 0.0};
  OK(um_model_create(context, path, &options, &model));
  OK(um_compare_plan_create(context, model, m, &plan));
  OK(um_compare_plan_trace(context, model, plan, &tables));
  OK(um_model_run(context, model, tables, &result));
  OK(um_core_allocate(context, m->count, sizeof *value, &value));
  OK(um_compare_predict(context, plan, tables, result, value));
  for (size_t i = 0; i < m->count; i++) largest[i % 2] = fmax(largest[i % 2], value[i]);
  for (size_t i = 0; i < m->count; i++) {
    m->row[i].sigma = hypot(SIGMA * value[i], 1e-3 * largest[i % 2]);
    m->row[i].value = value[i] + m->row[i].sigma * noise_of(i);
  }
  um_core_free(context, value);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &model);
}

/* Both passes of a truth, as sets "early" and "late" and, where these are wanted, each alone. */
static inline void measure_both(const char *with, struct um_compare_measurements *alone[2],
                                struct um_compare_measurements **both)
{
  struct um_model *model;
  struct um_compare_measurements *part[2];
  OK(um_model_create(context, path, NULL, &model));
  double start = model->scenario->time->start;
  um_model_destroy(context, &model);
  rows_of(start, 0.0, &part[0]);
  rows_of(start, APART, &part[1]);
  OK(um_compare_measurements_join(context, part, NULL, 2, both));
  measure(with, *both);
  for (size_t p = 0; p < 2; p++)
    for (size_t i = 0; i < part[p]->count; i++) {
      part[p]->row[i].value = (*both)->row[p * 2 * ROWS + i].value;
      part[p]->row[i].sigma = (*both)->row[p * 2 * ROWS + i].sigma;
    }
  for (size_t p = 0; p < 2; p++) {
    if (alone != NULL)
      alone[p] = part[p];
    else
      um_compare_measurements_destroy(context, &part[p]);
  }
}

#endif
