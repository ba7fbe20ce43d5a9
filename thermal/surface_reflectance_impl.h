/* What a surface does not absorb. Private to thermal/. */
#ifndef UMBRA_THERMAL_SURFACE_REFLECTANCE_IMPL_H
#define UMBRA_THERMAL_SURFACE_REFLECTANCE_IMPL_H

#include "irradiation/loads.h"
#include "thermal/network_impl.h"

/* Reflected shares of what falls on a surface at that row: of sunlight at its angle, of the albedo,
 * of the Earth's infrared. */
struct um_thermal_reflectances {
  double sun, albedo, planet;
};
struct um_thermal_reflectances
um_thermal_surface_reflectances(const struct um_thermal_network *network,
                                const struct um_irradiation_loads *loads, size_t row,
                                size_t surface);
#endif
