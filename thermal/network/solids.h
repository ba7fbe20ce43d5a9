/* Parts that are filled with tetrahedra, as a body keeps them. */
#ifndef UMBRA_THERMAL_SOLIDS_H
#define UMBRA_THERMAL_SOLIDS_H

#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"

struct um_thermal_tetrahedra;

struct um_thermal_solid {
  uint32_t part;
  struct um_thermal_tetrahedra *mesh; /* tetgen.h; in body frame with joints as for contacts */
  uint32_t *node;                     /* [mesh->nvertex] heat node of every vertex */
};
/* solid[nsolid]; NULL accepted, NULL afterwards. */
void um_thermal_solids_destroy(struct um_context *context, struct um_thermal_solid **solid,
                               size_t nsolid);

#endif
