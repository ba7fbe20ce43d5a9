/* What a surface does not absorb. Private to thermal/. */
#ifndef UMBRA_THERMAL_SURFACE_REFLECTANCE_IMPL_H
#define UMBRA_THERMAL_SURFACE_REFLECTANCE_IMPL_H

#include "irradiation/loads.h"
#include "thermal/network_impl.h"
#include "thermal/solve_options.h"

/* Reflected shares of what falls on a surface at that row: of sunlight at its angle, of the albedo,
 * of the Earth's infrared. aging NULL: nothing ages. */
struct um_thermal_reflectances {
  double sun, albedo, planet;
};
struct um_thermal_reflectances
um_thermal_surface_reflectances(const struct um_thermal_network *network,
                                const struct um_irradiation_loads *loads,
                                const struct um_thermal_aging *aging, size_t row, size_t surface);
#endif
