/* Parts of plane and round faces. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_PRIMITIVES_IMPL_H
#define UMBRA_GEOMETRY_PRIMITIVES_IMPL_H

#include "geometry/patch_impl.h"

/* Box, plate, sphere; hands the round ones on. Sizes have been checked. */
enum um_status um_geometry_primitive_build(const struct um_geometry_part_spec *spec,
                                           struct um_geometry_patch *patch);

#endif
