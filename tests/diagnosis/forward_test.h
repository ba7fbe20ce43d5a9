/* The small satellite of the comparison's tests with contacts, measured in both bands and at two
 * places, for tests that compute it with effects. */
#ifndef UMBRA_TESTS_DIAGNOSIS_FORWARD_H
#define UMBRA_TESTS_DIAGNOSIS_FORWARD_H

#include "compare/series.h"
#include "diagnosis/candidates.h"
#include "effects/effects.h"
#include "tests/compare/model_test.h"

#define CONTACTS                                                                                   \
  "contacts:\n"                                                                                    \
  "  - {a: bus.interior, b: panel, conductance_W_K: 0.5}\n"                                        \
  "  - {a: bus.+x, b: bus.-x, conductance_W_K: 0.2}\n"

/* scenario.yaml with contacts and more; the measurements of a pass that leaves the umbra. */
static inline void put_world(const char *more)
{
  char text[4096];
  um_core_context_set_threads(context, 1); /* too small to share */
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma,flag\n", file);
  for (int k = 0; k < 12; k++) {
    const char *const rows[] = {"band_irradiance,lwir,3e-12,3e-14,0", "magnitude_ab,vis,9,0.02,0",
                                "temperature,panel.front,280,0.5,0",
                                "temperature,bus.interior,290,0.5,0",
                                "temperature,bus.+y,290,0.5,1"};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
      fprintf(file, DAY "%02d:%02dZ,%s\n", 9 + k / 2, 30 * (k % 2), rows[i]);
  }
  assert_int_equal(fclose(file), 0);
  snprintf(text, sizeof text, "%s" CONTACTS "%s", scenario_text, more);
  put(SCENARIO, text);
}

static inline struct um_compare_measurements *measured(void)
{
  struct um_compare_measurements *m;
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  return m;
}

static inline struct um_diagnosis_forward *forward_of(const struct um_model_options *options,
                                                      const struct um_compare_measurements *m,
                                                      double loosened)
{
  struct um_diagnosis_forward *forward;
  assert_ok(um_diagnosis_forward_create(context, SCENARIO, options, m, loosened, &forward));
  return forward;
}

static inline struct um_diagnosis_addition addition_of(const char *name, const char *target,
                                                       double value)
{
  struct um_diagnosis_addition a = {.effect = um_effects_find(name), .target = target};
  assert_non_null(a.effect);
  for (size_t p = 0; p < a.effect->nparameter; p++) a.value[p] = a.effect->parameters[p].null_value;
  a.value[0] = value;
  return a;
}

/* What umbra compare would say: everything anew, effects by --with; value [nrow]. */
static inline enum um_status fresh_values(const struct um_model_options *options,
                                          const struct um_diagnosis_forward *forward,
                                          const struct um_diagnosis_addition *addition, size_t n,
                                          double *value)
{
  struct um_model_options all = options == NULL ? (struct um_model_options){0} : *options;
  struct um_model *model;
  struct um_model_trace *trace;
  struct um_model_result *result;
  char *text[4];
  double *rows = malloc(forward->measurements->count * sizeof *rows);
  for (size_t i = 0; i < n; i++)
    assert_ok(um_diagnosis_addition_text(context, &addition[i], &text[i]));
  all.last = (const char *const *)text;
  all.nlast = n;
  assert_ok(um_model_create(context, SCENARIO, &all, &model));
  assert_ok(um_compare_plan_trace(context, model, forward->plan, &trace));
  assert_ok(um_model_run(context, model, trace, &result));
  assert_ok(um_compare_predict(context, forward->plan, trace, result, rows));
  for (size_t j = 0; j < forward->nrow; j++) {
    double unused;
    um_compare_linear(forward->measurements->channel[forward->channel[j]].quantity,
                      rows[forward->row[j]], 1.0, &value[j], &unused);
  }
  free(rows);
  for (size_t i = 0; i < n; i++) um_core_free(context, text[i]);
  um_model_result_destroy(context, &result);
  um_model_trace_destroy(context, &trace);
  um_model_destroy(context, &model);
  return UM_OK;
}

#endif
