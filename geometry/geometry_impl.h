/* What a geometry holds. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_GEOMETRY_IMPL_H
#define UMBRA_GEOMETRY_GEOMETRY_IMPL_H

#include "geometry/geometry.h"

/* A part as it is kept. */
struct um_geometry_part {
  char *name;
  size_t parent; /* (size_t)-1: the body */
  struct um_vec3 position;
  struct um_quat rotation;
  enum um_geometry_joint_kind joint_kind;
  struct um_vec3 joint_axis, joint_normal;
  double joint_angle;
  struct um_geometry_schedule schedule;
  struct um_vec3 grain; /* unit */
  size_t joint;         /* index of its joint, or (size_t)-1 */
  size_t vertex_begin, vertex_end, facet_begin, facet_end;
  struct um_geometry_report report;
};

struct um_geometry {
  struct um_context *context;
  struct um_geometry_part *part; /* [npart] */
  size_t npart, njoint;
  size_t *order; /* [npart] parents before children */
  struct um_geometry_group *group;
  size_t ngroup;
  char **material;
  size_t nmaterial;
  struct um_geometry_mesh mesh;
  struct um_vec3 *vertex; /* [nvertex], part frame [m] */
  struct um_vec3 *normal; /* [nfacet], part frame */
};

/* Frees the arrays of a mesh that stands in another struct. */
void um_geometry_mesh_free(struct um_context *context, struct um_geometry_mesh *mesh);

/* um_geometry_surface_grain in the part's own frame. */
void um_geometry_part_grain(const struct um_geometry *geometry, size_t surface,
                            struct um_vec3 *grain, struct um_vec3 *across);

static inline struct um_vec3 um_geometry_cross_of(const struct um_vec3 *vertex,
                                                  const uint32_t corner[3])
{
  struct um_vec3 a = vertex[corner[0]];
  return um_vec3_cross(um_vec3_sub(vertex[corner[1]], a), um_vec3_sub(vertex[corner[2]], a));
}

#endif
