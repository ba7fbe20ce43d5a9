/* Sea and land under the air; private to environment/. */
#ifndef UMBRA_ENVIRONMENT_DAYLIGHT_GROUND_IMPL_H
#define UMBRA_ENVIRONMENT_DAYLIGHT_GROUND_IMPL_H

#include "environment/scatter_layer_impl.h"

#define UM_DAYLIGHT_FINE 120 /* azimuths over half a turn, a multiple of the table's */

/* Reflectance at the nodes of layers by azimuth, from toward the mirrored Sun to toward the Sun,
 * and its terms as a layer wants them. */
struct um_environment_daylight_ground {
  double rho[UM_SCATTER_NODES][UM_SCATTER_NODES][UM_DAYLIGHT_FINE + 1];
  struct um_environment_scatter_matrix term[UM_SCATTER_MODES];
};
void um_environment_daylight_sea(struct um_environment_daylight_ground *out);
void um_environment_daylight_land(struct um_environment_daylight_ground *out);

#endif
