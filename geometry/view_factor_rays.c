/* Rays from patches. Points go with directions as points of facets go with points of the Sun's disc
 * (points.c): a four-dimensional sequence of low discrepancy; the disc is lifted to the hemisphere
 * (Malley), which makes the cosine. */
#include "geometry/view_factor_rays_impl.h"

#include <math.h>

#include "base/core/sampling.h"
#include "geometry/visibility_data_impl.h"

#define KEY_RAY UINT64_C(0x76696577)

enum um_status um_geometry_ray_counts_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_patches *patches, size_t rays,
                                             size_t fewest, struct um_geometry_ray_counts *out)
{
  size_t nmember = patches->begin[patches->npatch];
  out->most = out->all = 0;
  UM_TRY(um_core_allocate(context, nmember, sizeof *out->count, &out->count));
  UM_TRY(um_core_allocate(context, nmember, sizeof *out->before, &out->before));
  for (size_t p = 0; p < patches->npatch; p++)
    for (size_t i = patches->begin[p]; i < patches->begin[p + 1]; i++) {
      double area = mesh->area[mesh->surface[patches->surface[i]].facet];
      double share = ceil((double)rays * area / patches->area[p] * (1.0 - 1e-12));
      out->count[i] = (size_t)fmax(share, fmin((double)rays, (double)fewest));
      if (i > patches->begin[p]) out->before[i] = out->before[i - 1] + out->count[i - 1];
      out->all += out->count[i];
      if (out->count[i] > out->most) out->most = out->count[i];
    }
  return UM_OK;
}

void um_geometry_ray_counts_clear(struct um_context *context, struct um_geometry_ray_counts *counts)
{
  UM_FREE(context, counts->count, counts->before);
}

void um_geometry_view_factor_rays(const struct um_geometry_mesh *mesh,
                                  const struct um_geometry_pose *pose,
                                  const struct um_geometry_patches *patches,
                                  const struct um_geometry_ray_counts *counts, size_t i,
                                  size_t begin, size_t n, struct um_geometry_ray *ray)
{
  uint32_t surface = patches->surface[i], facet = mesh->surface[surface].facet;
  uint64_t key = um_core_hash(KEY_RAY, patches->patch[surface]), start = key >> 16;
  struct um_vec3 across, along, normal = um_geometry_surface_normal(mesh, pose, surface);
  um_core_vec3_frame(normal, &across, &along);
  const uint32_t *c = mesh->corner[facet];
  struct um_vec3 corner = pose->vertex[c[0]];
  struct um_vec3 ab = um_vec3_sub(pose->vertex[c[1]], corner);
  struct um_vec3 ac = um_vec3_sub(pose->vertex[c[2]], corner);
  for (size_t k = 0; k < n; k++) {
    double u[2], w[3], xy[2];
    um_core_sample_2d(key, counts->before[i] + begin + k, u);
    um_core_sample_triangle(u, w);
    um_geometry_points_second(start + counts->before[i] + begin + k, u);
    um_core_sample_disc(u, xy);
    /* from a corner, so that points of a facet lie in its plane to the last place */
    struct um_vec3 origin = um_vec3_axpy(um_vec3_axpy(corner, w[1], ab), w[2], ac);
    double z = sqrt(fmax(0.0, 1.0 - xy[0] * xy[0] - xy[1] * xy[1]));
    struct um_vec3 d = um_vec3_axpy(um_vec3_scale(across, xy[0]), xy[1], along);
    ray[k] = (struct um_geometry_ray){origin, um_vec3_axpy(d, z, normal), INFINITY, facet};
  }
}
