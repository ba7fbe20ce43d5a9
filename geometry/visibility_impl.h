/* Rays side by side. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_VISIBILITY_IMPL_H
#define UMBRA_GEOMETRY_VISIBILITY_IMPL_H

#include "geometry/visibility.h"

/* um_geometry_visibility_occluded for rays that run nearly side by side. */
void um_geometry_visibility_occluded_coherent(const struct um_geometry_visibility *visibility,
                                              const struct um_geometry_ray *rays, size_t n,
                                              uint8_t *occluded);

#endif
