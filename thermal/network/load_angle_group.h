/* How angles of incidence act on what a surface absorbs. Private to the rooms of thermal/. */
#ifndef UMBRA_THERMAL_LOAD_ANGLE_GROUP_H
#define UMBRA_THERMAL_LOAD_ANGLE_GROUP_H

#include "thermal/loads/loads.h"
#include "thermal/network/network.h"

/* Absorptance of the direct sunlight at entry `at`, row * nsurface + surface, of the table, over
 * that at normal incidence [1]; over a turn its mean by what falls in; where none falls in, any. */
double um_thermal_load_angle(const struct um_thermal_surface_law *law,
                             const struct um_irradiation_loads *loads, size_t at);
/* What the surface absorbs at that entry of the albedo and of the Earth's own radiation [W/m^2]:
 *
 *   k alpha E_0 + alpha_start sum_k a_k E_k,   k' eps E_0 + eps sum_k a'_k E_k
 *
 * with alpha and eps those of the moment; what ages adds to the absorptance of all angles alike and
 * is a factor of the emittance of all. */
double um_thermal_load_albedo(const struct um_thermal_surface *surface,
                              const struct um_irradiation_loads *loads, size_t at,
                              double absorptance);
double um_thermal_load_planet(const struct um_thermal_surface *surface,
                              const struct um_irradiation_loads *loads, size_t at,
                              double emittance);
#endif
