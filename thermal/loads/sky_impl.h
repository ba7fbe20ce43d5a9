/* Private to thermal/loads/: what a sky holds. */
#ifndef UMBRA_IRRADIATION_SKY_IMPL_H
#define UMBRA_IRRADIATION_SKY_IMPL_H

#include "thermal/loads/normals_impl.h"
#include "thermal/loads/sky.h"

#define UM_IRRADIATION_CUBE_SIDE  32 /* 2.8 deg: the sky's own cells have 6.3 deg */
#define UM_IRRADIATION_CUBE_CELLS (6 * UM_IRRADIATION_CUBE_SIDE * UM_IRRADIATION_CUBE_SIDE)
#define UM_IRRADIATION_LANES      4 /* surfaces of one normal that are looked at side by side */

struct um_irradiation_sky {
  struct um_irradiation_normals normals;
  size_t *group;     /* [normals.n + 1] first group of a class: its surfaces that are not open, in
                        their order, by LANES */
  uint32_t *freedom; /* [groups][CUBE_CELLS] free fraction times 255 in the bits from 8 lane on; 0
                        behind the last surface */
};

#endif
