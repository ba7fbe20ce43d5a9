/* How much of its view each surface loses to the satellite, roughly. */
#include <math.h>

#include "base/core/sampling.h"
#include "geometry/view_factors.h"

#define RAYS     64
#define KEY_SEEN UINT64_C(0x7365656e)

static double share_of(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                       const struct um_geometry_visibility *visibility, size_t surface)
{
  struct um_geometry_ray ray[RAYS];
  uint8_t occluded[RAYS];
  uint32_t facet = mesh->surface[surface].facet;
  const uint32_t *c = mesh->corner[facet];
  struct um_vec3 normal = um_geometry_surface_normal(mesh, pose, surface), a = pose->vertex[c[0]];
  struct um_vec3 ab = um_vec3_sub(pose->vertex[c[1]], a), ac = um_vec3_sub(pose->vertex[c[2]], a);
  double sum = 0.0;
  for (uint64_t i = 0; i < RAYS; i++) {
    double u[2], w[3];
    um_core_sample_2d(um_core_hash(KEY_SEEN, surface), i, u);
    um_core_sample_triangle(u, w);
    um_core_sample_2d(um_core_hash(KEY_SEEN + 1, surface), i, u);
    ray[i] = (struct um_geometry_ray){um_vec3_axpy(um_vec3_axpy(a, w[1], ab), w[2], ac),
                                      um_core_sample_cosine(u, normal), INFINITY, facet};
  }
  um_geometry_visibility_occluded(visibility, ray, RAYS, occluded);
  for (size_t i = 0; i < RAYS; i++) sum += occluded[i];
  return sum / RAYS;
}

enum um_status um_geometry_view_factors_seen(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_pose *pose,
                                             const struct um_geometry_visibility *visibility,
                                             double *seen)
{
  long n = (long)mesh->nsurface;
#pragma omp parallel for schedule(dynamic, 16) num_threads(um_core_context_threads(context))
  for (long s = 0; s < n; s++)
    if (seen[s] >= 0.0 && !um_geometry_visibility_is_open(visibility, (size_t)s) &&
        !um_core_stopped(context))
      seen[s] += share_of(mesh, pose, visibility, (size_t)s);
  return um_core_stop_check(context, "surfaces were gathered");
}
