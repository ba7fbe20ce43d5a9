/* A table of measured heights. */
#include "materials/profile.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_materials_heights heights;
  struct um_materials_slope slope;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_materials_heights_read(context, path, &heights))) {
    if (um_fuzz_good(context, um_materials_heights_roughness(context, &heights, &slope)) &&
        !(slope.tau > 0.0 && slope.alpha > 0.0))
      um_fuzz_finding("a roughness that is none");
  } else if (heights.height != NULL) {
    um_fuzz_finding("heights in spite of the failure");
  }
  um_materials_heights_free(context, &heights);
}
