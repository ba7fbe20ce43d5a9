/* A file of view factors between two plates in two poses, as one of the cache and as a user's. */
#include "geometry/view_factor_file.h"

#include <math.h>
#include <stdio.h>

#include "tests/fuzz/fuzz.h"

static void look(const struct um_geometry_view_factor_set *set)
{
  for (size_t k = 0; k < set->npose; k++) {
    const struct um_geometry_view_factors *f = set->pose[k];
    for (size_t p = 0; p < f->npatch; p++) {
      double sum = f->space[p];
      for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
        sum += f->area[e];
        if (e > f->begin[p] && f->other[e] <= f->other[e - 1])
          um_fuzz_finding("row %zu does not ascend", p);
        if (!(um_geometry_view_factors_area(f, f->other[e], p) == f->area[e]))
          um_fuzz_finding("patches %zu and %u differ", p, (unsigned)f->other[e]);
      }
      if (!(fabs(sum / set->patches->area[p] - 1.0) < 1e-7))
        um_fuzz_finding("row %zu adds up to %g", p, sum);
    }
  }
}

/* What was read is written and read again. */
static void again(struct um_context *context, const struct um_geometry_view_factor_set *set)
{
  struct um_geometry_view_factors *pose[2] = {NULL, NULL};
  struct um_geometry_view_factor_set copy = *set;
  FILE *file = fopen(um_fuzz_out(), "w");
  if (file == NULL) um_fuzz_finding("no file to write");
  um_geometry_view_factor_file_write(set, file);
  if (fclose(file) != 0) um_fuzz_finding("no file to write");
  copy.patches = NULL;
  copy.pose = pose;
  if (!um_fuzz_good(context,
                    um_geometry_view_factor_file_read(context, um_fuzz_out(), true, &copy))) {
    if (!um_fuzz_memory_is_short()) um_fuzz_finding("what was written is refused");
    return;
  }
  look(&copy);
  for (int k = 0; k < 2; k++) um_geometry_view_factors_destroy(context, &pose[k]);
  um_geometry_patches_destroy(context, &copy.patches);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const struct um_geometry_skin skin = {NULL, "a", "b"};
  const char *path = um_fuzz_file(0, data, size);
  struct um_geometry *geometry = NULL;
  struct um_geometry_part_spec part[2];
  for (int k = 0; k < 2; k++)
    part[k] = (struct um_geometry_part_spec){.name = k ? "above" : "below",
                                             .shape = UM_SHAPE_PLATE,
                                             .size = {1, 1, 0},
                                             .position = {0, 0, k},
                                             .rotation = {1, 0, 0, 0},
                                             .skins = &skin,
                                             .nskin = 1};
  if (!um_fuzz_good(context, um_geometry_create(context, part, 2, &geometry))) return;
  for (int own = 0; own < 2; own++) {
    struct um_geometry_view_factors *pose[2] = {NULL, NULL};
    struct um_geometry_view_factor_set set = {.geometry = geometry,
                                              .mesh = um_geometry_mesh(geometry),
                                              .key = {1, 2, 3, 4},
                                              .npose = 2,
                                              .pose = pose};
    if (um_fuzz_good(context, um_geometry_view_factor_file_read(context, path, own == 1, &set))) {
      look(&set);
      again(context, &set);
    } else if (set.patches != NULL || pose[0] != NULL) {
      um_fuzz_finding("view factors in spite of the failure");
    }
    for (int k = 0; k < 2; k++) um_geometry_view_factors_destroy(context, &pose[k]);
    um_geometry_patches_destroy(context, &set.patches);
  }
  um_geometry_destroy(&geometry);
}
