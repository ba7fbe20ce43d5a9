/* A Wavefront OBJ as the surface of a part: open with two sides, closed, and solid. */
#include <math.h>

#include "geometry/geometry.h"
#include "geometry/obj_look.h"
#include "tests/fuzz/fuzz.h"

static void look(struct um_context *context, const struct um_geometry *geometry)
{
  const struct um_geometry_report report = um_geometry_report(geometry, 0);
  struct um_geometry_pose *pose = NULL;
  um_fuzz_finite(report.area, "the area");
  um_fuzz_finite(report.sharpest_angle, "the sharpest angle");
  if (!um_fuzz_good(context, um_geometry_pose_create(context, geometry, NULL, &pose))) return;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  for (size_t i = 0; i < mesh->nfacet; i++) {
    um_fuzz_finite(mesh->area[i], "the area of a facet");
    if (!(fabs(um_vec3_norm(pose->facet_normal[i]) - 1.0) < 1e-9))
      um_fuzz_finding("normal %zu has length %g", i, um_vec3_norm(pose->facet_normal[i]));
    for (int k = 0; k < 3; k++)
      if (mesh->corner[i][k] >= mesh->nvertex) um_fuzz_finding("facet %zu has no corner", i);
  }
  um_geometry_pose_destroy(context, &pose);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const struct um_geometry_skin skins[] = {{NULL, "a", "b"}, {NULL, "a", NULL}};
  const char *path = um_fuzz_file(0, data, size);
  struct um_geometry_obj_look groups;
  if (um_fuzz_good(context, um_geometry_obj_look(context, path, &groups)))
    for (size_t g = 0; g < groups.ngroup; g++)
      if (groups.group[g].part >= groups.npart || groups.group[g].nclosed > groups.group[g].nfacet)
        um_fuzz_finding("group %zu of no part, or with more closed than there are", g);
  um_geometry_obj_look_clear(context, &groups);
  for (int way = 0; way < 3; way++) {
    const struct um_geometry_part_spec part = {.name = "part",
                                               .shape = UM_SHAPE_MESH,
                                               .mesh_path = path,
                                               .mesh_scale = way == 1 ? 0.001 : 0.0,
                                               .skins = &skins[way > 0],
                                               .nskin = 1,
                                               .rotation = {1, 0, 0, 0},
                                               .solid = way == 2};
    struct um_geometry *geometry = NULL;
    if (um_fuzz_good(context, um_geometry_create(context, &part, 1, &geometry)))
      look(context, geometry);
    else if (geometry != NULL)
      um_fuzz_finding("a body in spite of the failure");
    um_geometry_destroy(&geometry);
  }
}
