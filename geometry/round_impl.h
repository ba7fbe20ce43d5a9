/* Round parts. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_ROUND_IMPL_H
#define UMBRA_GEOMETRY_ROUND_IMPL_H

#include "geometry/patch_impl.h"

/* Disc, cylinder, cone, paraboloid. */
enum um_status um_geometry_round_build(const struct um_geometry_part_spec *spec,
                                       struct um_geometry_patch *patch);

#endif
