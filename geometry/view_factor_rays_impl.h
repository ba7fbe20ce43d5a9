/* Private to geometry/: the rays by which patches look around. */
#ifndef UMBRA_GEOMETRY_VIEW_FACTOR_RAYS_IMPL_H
#define UMBRA_GEOMETRY_VIEW_FACTOR_RAYS_IMPL_H

#include "geometry/patches.h"
#include "geometry/visibility.h"

/* How many rays each member of the patches has; those of a patch go on from member to member along
 * one sequence. */
struct um_geometry_ray_counts {
  size_t *count;  /* [nmember] rays of each member of the patches */
  size_t *before; /* [nmember] rays of members of its patch before it */
  size_t most;    /* of a member */
  size_t all;
};

/* In all of a patch `rays` or a little more, and `fewest` of a member where there are so many. The
 * caller clears, after a failure too. */
enum um_status um_geometry_ray_counts_create(struct um_context *context,
                                             const struct um_geometry_mesh *mesh,
                                             const struct um_geometry_patches *patches, size_t rays,
                                             size_t fewest, struct um_geometry_ray_counts *out);
void um_geometry_ray_counts_clear(struct um_context *context,
                                  struct um_geometry_ray_counts *counts);

/* Rays [begin, begin + n) of member i: cosine-weighted, from points spread over its facet. */
void um_geometry_view_factor_rays(const struct um_geometry_mesh *mesh,
                                  const struct um_geometry_pose *pose,
                                  const struct um_geometry_patches *patches,
                                  const struct um_geometry_ray_counts *counts, size_t i,
                                  size_t begin, size_t n, struct um_geometry_ray *ray);

#endif
