/* Vertices of facets and of tetrahedra as arrays. */
#include "output/bodies_impl.h"

#include "thermal/network/tetgen.h"

static void put(double *xyz, size_t i, struct um_vec3 at)
{
  xyz[3 * i] = at.x;
  xyz[3 * i + 1] = at.y;
  xyz[3 * i + 2] = at.z;
}

enum um_status um_output_vertices(struct um_context *context, const struct um_output_run *run,
                                  size_t k, double *xyz)
{
  enum um_status status;
  const struct um_geometry *geometry = run->model->geometry;
  const struct um_environment_sample *at =
      &run->tables->sample[k * run->tables->nsub + run->tables->nsub / 2];
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL;
  UM_CHECK(um_core_allocate(context, um_geometry_joint_count(geometry), sizeof *angles, &angles));
  um_geometry_joint_angles(geometry, um_quat_apply(at->q, at->sun), at->t_tai, angles);
  UM_CHECK(um_geometry_pose_create(context, geometry, angles, &pose));
  for (size_t i = 0; i < um_geometry_mesh(geometry)->nvertex; i++) put(xyz, i, pose->vertex[i]);
done:
  um_core_free(context, angles);
  um_geometry_pose_destroy(context, &pose);
  return status;
}

size_t um_output_solid_vertices(const struct um_thermal_body *body)
{
  size_t n = 0;
  for (size_t i = 0; i < body->nsolid; i++) n += body->solid[i].mesh->nvertex;
  return n;
}

void um_output_solids(const struct um_thermal_body *body, double *xyz, int *node, int *corner)
{
  size_t first = 0, c = 0;
  for (size_t i = 0; i < body->nsolid; i++) {
    const struct um_thermal_tetrahedra *mesh = body->solid[i].mesh;
    for (size_t v = 0; v < mesh->nvertex; v++) {
      put(xyz, first + v, mesh->vertex[v]);
      node[first + v] = (int)body->solid[i].node[v];
    }
    for (size_t e = 0; e < mesh->ntetrahedron; e++)
      for (int k = 0; k < 4; k++) corner[c++] = (int)(first + mesh->corner[e][k]);
    first += mesh->nvertex;
  }
}
