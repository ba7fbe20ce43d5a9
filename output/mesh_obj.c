/* The outside of a satellite as Wavefront OBJ (geometry/obj.c reads it). */
#include "output/mesh_obj.h"

#include "base/core/csv.h"
#include "model/build/timeline.h"
#include "orbit/time.h"

static void put_vertices(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                         FILE *file)
{
  for (size_t v = 0; v < mesh->nvertex; v++) {
    char x[32], y[32], z[32];
    um_core_number_text(pose->vertex[v].x, x);
    um_core_number_text(pose->vertex[v].y, y);
    um_core_number_text(pose->vertex[v].z, z);
    fprintf(file, "v %s %s %s\n", x, y, z);
  }
}

/* Facets in their order: a line of names where part or group change. */
static void put_facets(const struct um_geometry *geometry, FILE *file)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  for (size_t f = 0; f < mesh->nfacet; f++) {
    const struct um_geometry_group *group = um_geometry_group(geometry, mesh->facet_group[f]);
    const char *part = um_geometry_part_name(geometry, mesh->facet_part[f]);
    bool first = f == 0;
    if (first || mesh->facet_part[f] != mesh->facet_part[f - 1]) fprintf(file, "o %s\n", part);
    if (first || mesh->facet_group[f] != mesh->facet_group[f - 1]) {
      fprintf(file, "g %s.%s\n", part, group->name);
      if (group->front_material != UM_GEOMETRY_NONE)
        fprintf(file, "usemtl %s\n", um_geometry_material_name(geometry, group->front_material));
      if (group->back_material != UM_GEOMETRY_NONE)
        fprintf(file, "# back: %s\n", um_geometry_material_name(geometry, group->back_material));
    }
    const uint32_t *corner = mesh->corner[f];
    fprintf(file, "f %u %u %u\n", corner[0] + 1, corner[1] + 1, corner[2] + 1);
  }
}

enum um_status um_output_write_obj(struct um_context *context, const struct um_model *model,
                                   FILE *file)
{
  enum um_status status;
  const struct um_geometry *geometry = model->geometry;
  struct um_environment_sample s;
  struct um_geometry_pose *pose = NULL;
  double *angles = NULL;
  char utc[32];
  size_t njoint = um_geometry_joint_count(geometry);
  if (njoint > 0) {
    UM_CHECK(um_core_allocate(context, njoint, sizeof *angles, &angles));
    UM_CHECK(um_model_sample_at(context, model, model->scenario->time->start, &s));
    um_geometry_joint_angles(geometry, um_quat_apply(s.q, s.sun), s.t_tai, angles);
  }
  UM_CHECK(um_geometry_pose_create(context, geometry, angles, &pose));
  um_orbit_time_format(model->scenario->time->start, utc);
  fprintf(file, "# %s: the outside in metres, body axes%s%s\n", model->scenario->name,
          njoint > 0 ? ", joints as at " : "", njoint > 0 ? utc : "");
  put_vertices(um_geometry_mesh(geometry), pose, file);
  put_facets(geometry, file);
  status = um_core_stop_check(context, "a mesh was written");
done:
  um_geometry_pose_destroy(context, &pose);
  um_core_free(context, angles);
  return status;
}
