/* A table of measured BRDFs. */
#include "materials/brdf_fit.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_materials_brdf *brdf = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_materials_brdf_read(context, path, &brdf))) {
    for (size_t r = 0; r < brdf->nrow; r++)
      if (!(brdf->row[r].brdf > 0.0) || brdf->row[r].surface >= brdf->nsurface)
        um_fuzz_finding("a row that is none");
  } else if (brdf != NULL) {
    um_fuzz_finding("rows in spite of the failure");
  }
  um_materials_brdf_destroy(context, &brdf);
}
