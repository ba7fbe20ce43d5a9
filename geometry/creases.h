/* Surfaces of flat patches, each tilted a little: creased MLI, panels that are not flat
 * (docs/physics/creases.md).
 *
 * The plane of a facet is cut into squares along its grain and across it. A square's slopes are
 *
 *   (a, b) = s (g1, g2),  s = tan(tilt), g1 and g2 normal numbers of variance 1,
 *
 * hashed from the seed, the part, the plane and the square's place in it: neighbouring facets of
 * one plane share patches however the plane is meshed, and a body that is turned, or a joint that
 * is moved, keeps its own. */
#ifndef UMBRA_GEOMETRY_CREASES_H
#define UMBRA_GEOMETRY_CREASES_H

#include <math.h>

#include "geometry/geometry.h"

/* How the patches of a group are tilted; no tilt: flat. */
struct um_geometry_creasing {
  double tilt_square; /* mean square of the tilt about each axis of the surface [rad^2] */
  double patch;       /* edge of a patch [m]; 0: patches too small to tell apart */
  uint64_t seed;
  bool sheet; /* it hangs: MLI, or said to be creased; else a panel, a wall */
};

/* Mean square slope per axis, s^2 = tan^2(tilt) [1]. */
static inline double um_geometry_slope_variance(const struct um_geometry_creasing *creasing)
{
  if (!(creasing->tilt_square > 0.0)) return 0.0;
  double slope = tan(sqrt(creasing->tilt_square));
  return slope * slope;
}

/* Patches, surface by surface. */
struct um_geometry_creases {
  size_t nsurface;
  size_t *first;         /* [nsurface + 1] */
  float *along, *across; /* [first[nsurface]] slopes along the grain and across it [1] */
  float *share;          /* [first[nsurface]] of the facet's area; sum 1 for each surface [1] */
};

/* Most patches of all surfaces together: 12 bytes each. */
#define UM_GEOMETRY_PATCHES_MOST 20000000.0

/* Patches of the surfaces with wanted[surface], by the creasing of their group [ngroup]; none for
 * others, for flat ones and for patch 0. UM_ERR_INPUT: more than UM_GEOMETRY_PATCHES_MOST (part
 * named); UM_ERR_MEMORY. The caller destroys. */
enum um_status um_geometry_creases_create(struct um_context *context,
                                          const struct um_geometry *geometry,
                                          const struct um_geometry_creasing *creasing,
                                          const bool *wanted, struct um_geometry_creases **out);
void um_geometry_creases_destroy(struct um_context *context, struct um_geometry_creases **creases);

#endif
