/* What a surface does not absorb. Private to the rooms of thermal/. */
#ifndef UMBRA_THERMAL_SURFACE_REFLECTANCE_GROUP_H
#define UMBRA_THERMAL_SURFACE_REFLECTANCE_GROUP_H

#include "thermal/loads/loads.h"
#include "thermal/network/network_group.h"
#include "thermal/network/solve_options.h"

/* The loads that are reflected. */
enum um_thermal_load { UM_THERMAL_SUN, UM_THERMAL_ALBEDO, UM_THERMAL_PLANET };

/* Reflected share of what of a load falls on a surface at that row [1]: of sunlight at its angle.
 * aging NULL: nothing ages. */
double um_thermal_surface_reflectance(const struct um_thermal_network *network,
                                      const struct um_irradiation_loads *loads,
                                      const struct um_thermal_aging *aging, size_t row,
                                      size_t surface, enum um_thermal_load load);
#endif
