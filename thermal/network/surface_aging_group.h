/* Optics of surfaces that age. Private to the rooms of thermal/. */
#ifndef UMBRA_THERMAL_SURFACE_AGING_GROUP_H
#define UMBRA_THERMAL_SURFACE_AGING_GROUP_H

#include "thermal/network/network_group.h"
#include "thermal/network/solve_options.h"

/* At a row of the loads: absorptance of a surface, factor on its emittance; aging NULL: as stated.
 */
double um_thermal_aged_absorptance(const struct um_thermal_network *network,
                                   const struct um_thermal_aging *aging, size_t row, size_t s);
double um_thermal_aged_emittance(const struct um_thermal_aging *aging, size_t row, size_t s);

#endif
