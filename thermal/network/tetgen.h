/* TetGen behind C. Runs in a forked child with time and memory limits; inputs are checked first. */
#ifndef UMBRA_THERMAL_TETGEN_H
#define UMBRA_THERMAL_TETGEN_H

#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"
#include "base/core/vec.h"

struct um_thermal_tetrahedra {
  size_t nvertex, ntetrahedron;
  struct um_vec3 *vertex; /* [nvertex] [m]; the first ones are the surface's, in order */
  uint32_t (*corner)[4];  /* [ntetrahedron], positive volume */
  /* what it fills */
  size_t nsurface;      /* vertices of the surface */
  uint32_t (*facet)[3]; /* [nfacet] */
  size_t nfacet;
  double edge; /* [m] */
};
/* Fill a closed surface. Surface vertices and facets are kept. edge: longest edge wanted [m], 0
 * free. UM_ERR_INPUT: non-finite, coincident, open, self-intersecting (naming two facets), or no
 * tetrahedron; UM_ERR_LIBRARY: TetGen crashed, ran out of time or memory. `name` is the user's. */
enum um_status um_thermal_tetgen_fill(struct um_context *context, const char *name,
                                      const struct um_vec3 *vertex, size_t nvertex,
                                      const uint32_t (*facet)[3], size_t nfacet, double edge,
                                      struct um_thermal_tetrahedra **out);
/* Do they fill this very surface, with this edge? Arguments as above. */
bool um_thermal_tetrahedra_fill(const struct um_thermal_tetrahedra *tetrahedra,
                                const struct um_vec3 *vertex, size_t nvertex,
                                const uint32_t (*facet)[3], size_t nfacet, double edge);
enum um_status um_thermal_tetrahedra_copy(struct um_context *context,
                                          const struct um_thermal_tetrahedra *tetrahedra,
                                          struct um_thermal_tetrahedra **out);
void um_thermal_tetrahedra_destroy(struct um_context *context,
                                   struct um_thermal_tetrahedra **tetrahedra);

#endif
