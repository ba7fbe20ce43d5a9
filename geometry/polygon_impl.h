/* Polygons as triangles. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_POLYGON_IMPL_H
#define UMBRA_GEOMETRY_POLYGON_IMPL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/core/vec.h"

/* n - 2 triangles of a simple polygon, as indices into p; false when it crosses itself or has no
 * area. work is [n]. */
bool um_geometry_polygon_triangulate(const struct um_vec3 *p, size_t n, uint32_t *work,
                                     uint32_t (*triangle)[3]);

#endif
