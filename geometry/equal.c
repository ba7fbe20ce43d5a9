/* Two geometries, number for number. */
#include <string.h>

#include "geometry/geometry_impl.h"

static bool same(const void *a, const void *b, size_t count, size_t size)
{
  return count == 0 || memcmp(a, b, count * size) == 0;
}

static bool same_vec(struct um_vec3 a, struct um_vec3 b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool schedule_equal(const struct um_geometry_schedule *a,
                           const struct um_geometry_schedule *b)
{
  if (a->nrow != b->nrow) return false;
  for (size_t i = 0; i < a->nrow; i++)
    if (a->t[i] != b->t[i] || a->angle[i] != b->angle[i]) return false;
  return true;
}

static bool part_equal(const struct um_geometry_part *a, const struct um_geometry_part *b)
{
  return a->parent == b->parent && a->joint == b->joint && a->joint_kind == b->joint_kind &&
         a->joint_angle == b->joint_angle && schedule_equal(&a->schedule, &b->schedule) &&
         same_vec(a->position, b->position) && a->rotation.w == b->rotation.w &&
         a->rotation.x == b->rotation.x && a->rotation.y == b->rotation.y &&
         a->rotation.z == b->rotation.z && same_vec(a->joint_axis, b->joint_axis) &&
         same_vec(a->joint_normal, b->joint_normal) && a->vertex_begin == b->vertex_begin &&
         a->vertex_end == b->vertex_end && a->facet_begin == b->facet_begin &&
         a->facet_end == b->facet_end;
}

static bool group_equal(const struct um_geometry_group *a, const struct um_geometry_group *b)
{
  return a->part == b->part && a->front_material == b->front_material &&
         a->back_material == b->back_material;
}

static bool surface_equal(const struct um_geometry_surface *a, const struct um_geometry_surface *b)
{
  return a->facet == b->facet && a->part == b->part && a->group == b->group &&
         a->material == b->material && a->back == b->back;
}

static bool mesh_equal(const struct um_geometry_mesh *a, const struct um_geometry_mesh *b)
{
  if (a->nvertex != b->nvertex || a->nfacet != b->nfacet || a->nsurface != b->nsurface)
    return false;
  for (size_t s = 0; s < a->nsurface; s++)
    if (!surface_equal(&a->surface[s], &b->surface[s])) return false;
  return same(a->corner, b->corner, a->nfacet, sizeof *a->corner) &&
         same(a->facet_part, b->facet_part, a->nfacet, sizeof *a->facet_part) &&
         same(a->facet_group, b->facet_group, a->nfacet, sizeof *a->facet_group);
}

bool um_geometry_equal(const struct um_geometry *a, const struct um_geometry *b)
{
  if (a == b) return true;
  if (a->npart != b->npart || a->njoint != b->njoint || a->ngroup != b->ngroup ||
      a->nmaterial != b->nmaterial || !mesh_equal(&a->mesh, &b->mesh))
    return false;
  for (size_t p = 0; p < a->npart; p++)
    if (!part_equal(&a->part[p], &b->part[p])) return false;
  for (size_t g = 0; g < a->ngroup; g++)
    if (!group_equal(&a->group[g], &b->group[g])) return false;
  return same(a->vertex, b->vertex, a->mesh.nvertex, sizeof *a->vertex);
}
