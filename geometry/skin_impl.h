/* Groups and materials of a part. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_SKIN_IMPL_H
#define UMBRA_GEOMETRY_SKIN_IMPL_H

#include "geometry/geometry_impl.h"
#include "geometry/patch_impl.h"

/* Take over groups and materials of one part whose facets are in `patch`; closed[nfacet]. */
enum um_status um_geometry_skin_apply(struct um_geometry *geometry,
                                      const struct um_geometry_part_spec *spec, uint32_t part,
                                      const struct um_geometry_patch *patch, const uint8_t *closed);

#endif
