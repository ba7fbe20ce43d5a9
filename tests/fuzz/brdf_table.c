/* A table of a BRDF over the hemisphere. */
#include "materials/measured.h"
#include "tests/fuzz/fuzz.h"

#define LARGE 20000 /* directions of a table that is tried */

static void one(struct um_context *context, const struct um_materials_measured_grid *grid)
{
  struct um_materials_measured *m = NULL;
  for (int renormalise = 0; renormalise < 2; renormalise++) {
    if (!um_fuzz_good(context, um_materials_measured_create(context, grid, renormalise == 1, &m)))
      continue;
    double there = um_materials_measured_evaluate(m, 0.3, 0.7, 0.8),
           back = um_materials_measured_evaluate(m, 0.7, 0.3, 0.8);
    um_fuzz_finite(there, "a BRDF");
    if (!(there > 0.0 && there - back <= 1e-9 * there && back - there <= 1e-9 * there))
      um_fuzz_finding("%.17g one way, %.17g the other", there, back);
    um_fuzz_finite(um_materials_measured_albedo_mean(m), "an albedo");
    if (renormalise == 1 && !(um_materials_measured_albedo_most(m) <= 1.0 + 1e-9))
      um_fuzz_finding("renormalised to %.17g", um_materials_measured_albedo_most(m));
    double cosine = um_materials_measured_draw(m, 0.6);
    if (!(cosine >= 0.0 && cosine <= 1.0 && um_materials_measured_half_density(m, cosine) > 0.0))
      um_fuzz_finding("a half vector of cosine %.17g", cosine);
    um_materials_measured_destroy(context, &m);
  }
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_materials_measured_grid grid;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_materials_measured_read(context, path, &grid))) {
    if (grid.npolar * grid.npolar * grid.nazimuth <= LARGE) one(context, &grid);
  } else if (grid.f != NULL || grid.polar != NULL) {
    um_fuzz_finding("a grid in spite of the failure");
  }
  um_materials_measured_grid_free(context, &grid);
}
