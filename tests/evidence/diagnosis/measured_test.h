/* Measurements made from a scenario, for tests of a diagnosis. */
#ifndef UMBRA_TESTS_DIAGNOSIS_MEASURED_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_MEASURED_TEST_H

#include "evidence/inversion/synth.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"

/* The scenario with these changes, of noise 1 % and 0.1 % of the brightest. Returns its first
 * instant [s TAI]; the caller destroys *out. */
static inline double measured_make(struct um_context *context, const char *path,
                                   const struct um_model_options *options,
                                   struct um_compare_measurements **out)
{
  const struct um_compare_synth noise = {.relative = 0.01, .floor = 0.001, .seed = 11};
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  if (um_model_create(context, path, options, &model) != UM_OK ||
      um_model_precompute(context, model, &tables) != UM_OK ||
      um_model_run(context, model, tables, &result) != UM_OK ||
      um_compare_synth_create(context, model, tables, result, &noise, "made", out) != UM_OK)
    fail_msg("%s: %s", path, um_core_message(context));
  double first = tables->t_obs[0];
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return first;
}

#endif
