/* The small satellite of the comparison's tests with contacts, measured in both bands and at two
 * places, for tests that compute it with effects. */
#ifndef UMBRA_TESTS_SENSITIVITY_FORWARD_TEST_H
#define UMBRA_TESTS_SENSITIVITY_FORWARD_TEST_H

#include "effects/effects.h"
#include "evidence/sensitivity/forward.h"
#include "tests/evidence/model_test.h"

#define CONTACTS                                                                                   \
  "contacts:\n"                                                                                    \
  "  - {a: bus.interior, b: panel, conductance_W_K: 0.5}\n"                                        \
  "  - {a: bus.+x, b: bus.-x, conductance_W_K: 0.2}\n"

/* The measurements of a pass that leaves the umbra; extra: one more at each time, or NULL. */
static inline void put_measured(const char *extra)
{
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
    if (extra != NULL) fprintf(file, DAY "%02d:%02dZ,%s\n", 9 + k / 2, 30 * (k % 2), extra);
  }
  assert_int_equal(fclose(file), 0);
}

/* scenario.yaml with contacts and more, and its measurements. */
static inline void put_world(const char *more)
{
  char text[4096];
  um_core_context_set_threads(context, 1); /* too small to share */
  put_measured(NULL);
  snprintf(text, sizeof text, "%s" CONTACTS "%s", scenario_text, more);
  put(SCENARIO, text);
}

static inline struct um_compare_measurements *measured(void)
{
  struct um_compare_measurements *m;
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  return m;
}

static inline struct um_sensitivity_forward *forward_of(const struct um_model_options *options,
                                                        const struct um_compare_measurements *m)
{
  struct um_sensitivity_forward *forward;
  assert_ok(
      um_sensitivity_forward_create(context, SCENARIO, options, m, UM_VARIANT_TIGHT, &forward));
  return forward;
}

static inline struct um_model_addition addition_of(const char *name, const char *target,
                                                   double value)
{
  struct um_model_addition a = {.effect = um_effects_find(name), .target = target};
  assert_non_null(a.effect);
  for (size_t p = 0; p < a.effect->nparameter; p++) a.value[p] = a.effect->parameters[p].null_value;
  a.value[0] = value;
  return a;
}

/* "effect:target,name=value,..." as --with takes it, values with all digits. */
static inline char *addition_text(const struct um_model_addition *a)
{
  char *text = malloc(1024);
  int at = snprintf(text, 1024, "%s%s%s", a->effect->name, a->target != NULL ? ":" : "",
                    a->target != NULL ? a->target : "");
  for (size_t p = 0; p < a->effect->nparameter; p++)
    at += snprintf(text + at, 1024 - (size_t)at, ",%s=%.17g", a->effect->parameters[p].name,
                   a->value[p]);
  return text;
}

/* What umbra compare would say: everything anew, effects by --with, with as many samples as the
 * forward has; value [nobservation]. */
static inline enum um_status fresh_values(const struct um_model_options *options,
                                          const struct um_sensitivity_forward *forward,
                                          const struct um_model_addition *addition, size_t n,
                                          double *value)
{
  struct um_model_options all = options == NULL ? (struct um_model_options){0} : *options;
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
  char *text[8];
  double *rows = malloc(forward->measurements->count * sizeof *rows);
  size_t before = all.nwith;
  const char *overrides[12];
  char samples[40], paths[48];
  assert_true(all.noverride + 1 < sizeof overrides / sizeof *overrides);
  for (size_t i = 0; i < all.noverride; i++) overrides[i] = all.overrides[i];
  snprintf(samples, sizeof samples, "optics.samples=%d", forward->samples);
  overrides[all.noverride++] = samples;
  snprintf(paths, sizeof paths, "optics.interreflection_samples=%d", forward->paths);
  overrides[all.noverride++] = paths;
  all.overrides = overrides;
  const char *kept[4]; /* --without comes last: what is added is not taken away */
  size_t nkept = 0;
  for (size_t k = 0; k < all.nwithout; k++) {
    bool added = false;
    for (size_t i = 0; i < n; i++)
      added = added || strcmp(all.without[k], addition[i].effect->name) == 0;
    if (!added) kept[nkept++] = all.without[k];
  }
  all.without = kept;
  all.nwithout = nkept;
  for (size_t i = 0; i < before; i++) text[i] = strdup(all.with[i]);
  for (size_t i = 0; i < n; i++) text[before + i] = addition_text(&addition[i]);
  all.with = (const char *const *)text;
  all.nwith = before + n;
  assert_ok(um_model_create(context, SCENARIO, &all, &model));
  assert_ok(um_compare_plan_trace(context, model, forward->plan, &tables));
  assert_ok(um_model_run(context, model, tables, &result));
  assert_ok(um_compare_predict(context, forward->plan, tables, result, rows));
  um_compare_modelled(forward->measurements, forward->observations.count, forward->observations.row,
                      rows, value);
  free(rows);
  for (size_t i = 0; i < all.nwith; i++) free(text[i]);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return UM_OK;
}

#endif
