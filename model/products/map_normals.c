/* Normals of a body, each once. */
#include "model/products/map_normals_impl.h"

#include <math.h>

#include "base/core/constants.h"

#define SAME (0.1 * UM_DEG)
#define MOST 4096

static void add(struct um_model_map_normals *normals, struct um_vec3 unit, double area)
{
  for (size_t i = 0; i < normals->n; i++)
    if (um_vec3_angle(normals->normal[i].unit, unit) < SAME) {
      normals->normal[i].area += area;
      return;
    }
  if (normals->n < MOST)
    normals->normal[normals->n++] = (struct um_model_map_normal){
        atan2(unit.z, hypot(unit.x, unit.y)), atan2(unit.y, unit.x), unit, area};
}

enum um_status um_model_map_normals_find(struct um_context *context, const struct um_model *model,
                                         struct um_model_map_normals *out)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t njoint = um_geometry_joint_count(model->geometry);
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL;
  *out = (struct um_model_map_normals){0};
  if (um_geometry_joint_moves(model->geometry)) return UM_OK;
  UM_CHECK(um_core_allocate(context, MOST, sizeof *out->normal, &out->normal));
  UM_CHECK(um_core_allocate(context, njoint, sizeof *angles, &angles));
  um_geometry_joint_angles(model->geometry, um_vec3(1.0, 0.0, 0.0), INFINITY, angles);
  UM_CHECK(um_geometry_pose_create(context, model->geometry, njoint > 0 ? angles : NULL, &pose));
  for (size_t s = 0; s < mesh->nsurface; s++)
    add(out, um_geometry_surface_normal(mesh, pose, s), mesh->area[mesh->surface[s].facet]);
done:
  um_geometry_pose_destroy(context, &pose);
  um_core_free(context, angles);
  return status;
}
