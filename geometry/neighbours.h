/* Which facets lie beside each other. */
#ifndef UMBRA_GEOMETRY_NEIGHBOURS_H
#define UMBRA_GEOMETRY_NEIGHBOURS_H

#include "geometry/geometry.h"

/* (*out)[f][k]: the facet beyond the edge from corner k to corner k + 1 of facet f;
 * UM_GEOMETRY_NONE where no facet or more than one lies there. Parts share no edge. The caller
 * frees *out. UM_ERR_MEMORY. */
enum um_status um_geometry_neighbours(struct um_context *context,
                                      const struct um_geometry_mesh *mesh, uint32_t (**out)[3]);

#endif
