/* Private to geometry/: what the visibility files share, without Embree's types. */
#ifndef UMBRA_GEOMETRY_VISIBILITY_IMPL_H
#define UMBRA_GEOMETRY_VISIBILITY_IMPL_H

#include "geometry/visibility.h"

/* A vertex within this times the model size of a plane lies in it [1]. */
#define UM_GEOMETRY_PLANE 1e-9

struct um_geometry_visibility {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  const struct um_geometry_pose *pose;
  struct um_vec3 centre; /* of the bounding box; Embree's origin [m] */
  double size;           /* diagonal of the bounding box [m] */
  uint8_t *open;         /* [nsurface] */
  void *device, *scene;  /* Embree's */
};

/* Fills visibility->open. */
enum um_status um_geometry_horizon_find(struct um_geometry_visibility *visibility);

/* Point `sample` of a facet, the same for every query. */
struct um_vec3 um_geometry_sample_point(const struct um_geometry_visibility *visibility,
                                        uint32_t facet, uint64_t sample);

/* Point `index` in [0,1)^2 of a second sequence, to be paired with um_core_sample_2d at the same
 * index: two R2 sequences differ by a shift only, so that a pair of them would fill no more than a
 * plane of the four-dimensional cube. */
void um_geometry_sample_second(uint64_t key, uint64_t index, double out[2]);

/* um_geometry_visibility_occluded for rays that run nearly side by side. */
void um_geometry_visibility_occluded_coherent(const struct um_geometry_visibility *visibility,
                                              const struct um_geometry_ray *rays, size_t n,
                                              uint8_t *occluded);

#endif
