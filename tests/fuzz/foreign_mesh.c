/* Meshes of other formats: what a child of Assimp makes of them, and what we make of that. */
#include "geometry/obj_look.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  const char *path = um_fuzz_file(0, data, size);
  struct um_geometry_obj_look look;
  if (um_fuzz_good(context, um_geometry_obj_look(context, path, &look)))
    for (size_t g = 0; g < look.ngroup; g++)
      if (look.group[g].part >= look.npart || look.group[g].name[0] == '\0')
        um_fuzz_finding("group %zu of no part or without a name", g);
  um_fuzz_finite(look.high.x - look.low.x, "the size");
  um_geometry_obj_look_clear(context, &look);
}
