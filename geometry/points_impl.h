/* The point sequences of all queries. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_POINTS_IMPL_H
#define UMBRA_GEOMETRY_POINTS_IMPL_H

#include "geometry/visibility_data_impl.h"

/* Fills visibility->weight and visibility->disc. */
void um_geometry_points_fill(struct um_geometry_visibility *visibility);
/* Point `sample` of a facet, the same for every query of a seed. */
struct um_vec3 um_geometry_points_facet(const struct um_geometry_visibility *visibility,
                                        uint64_t seed, uint32_t facet, uint64_t sample);
/* Point `sample` of the unit disc that goes with it. */
void um_geometry_points_disc(const struct um_geometry_visibility *visibility, uint64_t seed,
                             uint32_t facet, uint64_t sample, double xy[2]);
/* Point in [0,1)^2 of the second sequence, see points.c. */
void um_geometry_points_second(uint64_t index, double out[2]);

#endif
