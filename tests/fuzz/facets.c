/* Halvings of the facets of a plate, in a small scenario that is built. */
#include <stdio.h>
#include <stdlib.h>

#include "model/build/build.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/wing.h"

/* 2 m2 whatever was cut. */
static void look(const struct um_model *model)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  double area = 0.0;
  for (size_t f = 0; f < mesh->nfacet; f++) area += mesh->area[f];
  if (!(area > 2.0 - 1e-9 && area < 2.0 + 1e-9)) um_fuzz_finding("a plate of another area");
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char set[96];
  const char *const overrides[] = {set};
  const struct um_model_options options = {.overrides = overrides, .noverride = 1};
  struct um_model *model = NULL;
  setenv("UMBRA_DATA", UMBRA_SOURCE_DIR "/tests/fuzz/data", 1);
  snprintf(set, sizeof set, "thermal.facets=%s", um_fuzz_file(0, data, size));
  if (um_fuzz_good(context, um_model_create(context, um_fuzz_file(1, wing, sizeof wing - 1),
                                            &options, &model)))
    look(model);
  else if (model != NULL)
    um_fuzz_finding("a model in spite of the failure");
  um_model_destroy(context, &model);
}
