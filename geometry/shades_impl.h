/* What stands before a surface toward a direction, of a body of few facets. Private to geometry/.
 */
#ifndef UMBRA_GEOMETRY_SHADES_IMPL_H
#define UMBRA_GEOMETRY_SHADES_IMPL_H

#include <stdbool.h>

#include "geometry/visibility_data_impl.h"

/* Facets that may stand before a surface at most; beyond it rays are as quick. */
#define UM_GEOMETRY_SHADES_MOST 32

/* A body as it is seen from one direction: vertices across it and along it [m]. */
struct um_geometry_shades_look {
  const struct um_geometry_visibility *visibility;
  struct um_vec3 vertex[UM_GEOMETRY_SHADES_VERTICES];
};

/* What a facet hides of another: points whose weights w make all four of c0 + c1 w1 + c2 w2 not
 * negative, three for the edges that they lie within, one since it stands before them. */
struct um_geometry_shade {
  double c[4][3];
};

/* Fills visibility->before and visibility->before_begin, which stay NULL for a body that has more
 * facets or vertices than are looked at. UM_ERR_MEMORY. */
enum um_status um_geometry_shades_find(struct um_geometry_visibility *visibility);

/* The body toward the unit direction d; false where rays are to be asked. */
bool um_geometry_shades_toward(const struct um_geometry_visibility *visibility, struct um_vec3 d,
                               struct um_geometry_shades_look *out);
/* Facets that stand before any of a surface that faces the direction, or come as near as `margin`
 * across it [m]: how many; none: the surface is free, without exception. SIZE_MAX: more than
 * UM_GEOMETRY_SHADES_MOST, or one is seen edge-on, and rays have to say. shade: their shadows,
 * NULL: they are counted. */
size_t um_geometry_shades_before(const struct um_geometry_shades_look *look, size_t surface,
                                 double margin,
                                 struct um_geometry_shade shade[UM_GEOMETRY_SHADES_MOST]);
/* Which of the points [n], n <= UM_GEOMETRY_POINTS, of a facet lie in any of the shadows; hidden
 * [n]. */
void um_geometry_shades_on(const struct um_geometry_visibility *visibility, uint64_t seed,
                           uint32_t facet, const struct um_geometry_shade *shade, size_t nshade,
                           size_t n, uint8_t *hidden);

#endif
