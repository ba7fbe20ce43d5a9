/* A history of power of a group and of an interior, in a small scenario that is built and run. */
#include <stdio.h>
#include <stdlib.h>

#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/run.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/wing.h"

static void run(struct um_context *context, const struct um_model *model)
{
  struct um_model_tables *tables = NULL;
  struct um_model_result *r = NULL;
  if (um_fuzz_good(context, um_model_precompute(context, model, &tables)) &&
      um_fuzz_good(context, um_model_run(context, model, tables, &r)))
    for (size_t i = 0; i < r->nobs * r->nnode; i++)
      um_fuzz_finite(r->node_temperature[i], "the temperature of a node");
  um_model_result_destroy(context, &r);
  um_model_tables_destroy(context, &tables);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char set[96];
  const char *const overrides[] = {set};
  const struct um_model_options options = {.overrides = overrides, .noverride = 1};
  struct um_model *model = NULL;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  snprintf(set, sizeof set, "parts.wing.groups={plate: {power_file: %s}}",
           um_fuzz_file(0, data, size));
  if (um_fuzz_good(context, um_model_create(context, um_fuzz_file(1, wing, sizeof wing - 1),
                                            &options, &model)))
    run(context, model);
  else if (model != NULL)
    um_fuzz_finding("a model in spite of the failure");
  um_model_destroy(context, &model);
}
