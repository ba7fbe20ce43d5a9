/* Private to thermal/network/: what TetGen cannot stand. */
#ifndef UMBRA_THERMAL_TETGEN_CHECK_IMPL_H
#define UMBRA_THERMAL_TETGEN_CHECK_IMPL_H

#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"
#include "base/core/vec.h"

struct um_thermal_tetgen_surface {
  const char *name;
  const struct um_vec3 *vertex; /* [nvertex] [m] */
  size_t nvertex;
  const uint32_t (*facet)[3]; /* [nfacet] */
  size_t nfacet;
  double size;   /* diagonal of the bounding box [m] */
  double volume; /* enclosed [m^3] */
  double *hole;  /* [nhole][3] a point in every cavity [m] */
  size_t nhole;
};
/* Refuse what TetGen cannot stand; fills size, volume and holes. The caller frees hole. */
enum um_status um_thermal_tetgen_check(struct um_context *context,
                                       struct um_thermal_tetgen_surface *surface);
/* Among the facets that TetGen flags as crossing, two that do. */
void um_thermal_tetgen_crossing(const struct um_thermal_tetgen_surface *surface, const int *flagged,
                                size_t nflagged, uint32_t pair[2]);

#endif
