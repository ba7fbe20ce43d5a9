/* What visibility asks its rays about: facets, points, surfaces that nothing stands before. Private
 * to geometry/. */
#ifndef UMBRA_GEOMETRY_VISIBILITY_DATA_IMPL_H
#define UMBRA_GEOMETRY_VISIBILITY_DATA_IMPL_H

#include "geometry/geometry.h"

/* A vertex within this times the model size of a plane lies in it [1]. */
#define UM_GEOMETRY_PLANE 1e-9

/* Blur of Embree's hit points relative to the model size [1]: about 80 units in the last place. */
#define UM_GEOMETRY_BLUR 1e-5

/* First indices of facets in the point sequences lie below this, as do the samples that need no
 * evaluation. */
#define UM_GEOMETRY_POINTS 1024

/* Facets and vertices of a body whose shadows are looked at without rays, at most. */
#define UM_GEOMETRY_SHADES_FACETS   128
#define UM_GEOMETRY_SHADES_VERTICES 256

struct um_geometry_visibility {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  const struct um_geometry_pose *pose;
  struct um_vec3 centre; /* of the bounding box; Embree's origin [m] */
  double size;           /* diagonal of the bounding box [m] */
  uint8_t *open;         /* [nsurface] */
  uint32_t *before;      /* facets that rise above the plane of a surface that is not open, one
                            surface after another; NULL: rays are asked */
  size_t *before_begin;  /* [nsurface + 1] */
  double weight[2 * UM_GEOMETRY_POINTS][2]; /* barycentric weights of corners 1 and 2 */
  double disc[2 * UM_GEOMETRY_POINTS][2];   /* points of the unit disc */
  void *device, *scene;                     /* Embree's */
};

/* Fills visibility->weight and visibility->disc. */
void um_geometry_points_fill(struct um_geometry_visibility *visibility);
/* Point `sample` of a facet, the same for every query of a seed. */
struct um_vec3 um_geometry_points_facet(const struct um_geometry_visibility *visibility,
                                        uint64_t seed, uint32_t facet, uint64_t sample);
/* Barycentric weights of corners 1 and 2 of its points [UM_GEOMETRY_POINTS]. */
const double (*um_geometry_points_weights(const struct um_geometry_visibility *visibility,
                                          uint64_t seed, uint32_t facet))[2];
/* Point `sample` of the unit disc that goes with it. */
void um_geometry_points_disc(const struct um_geometry_visibility *visibility, uint64_t seed,
                             uint32_t facet, uint64_t sample, double xy[2]);
/* Point in [0,1)^2 of the second sequence, see points.c. */
void um_geometry_points_second(uint64_t index, double out[2]);

/* Fills visibility->open. */
enum um_status um_geometry_horizon_find(struct um_geometry_visibility *visibility);

#endif
