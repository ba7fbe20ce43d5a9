/* What a visibility holds, without Embree's types. Private to geometry/. */
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

struct um_geometry_visibility {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  const struct um_geometry_pose *pose;
  struct um_vec3 centre;                    /* of the bounding box; Embree's origin [m] */
  double size;                              /* diagonal of the bounding box [m] */
  uint8_t *open;                            /* [nsurface] */
  double weight[2 * UM_GEOMETRY_POINTS][2]; /* barycentric weights of corners 1 and 2 */
  double disc[2 * UM_GEOMETRY_POINTS][2];   /* points of the unit disc */
  void *device, *scene;                     /* Embree's */
};

#endif
