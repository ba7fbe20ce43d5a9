/* How the angle of incidence acts on what a surface absorbs. Private to thermal/. */
#ifndef UMBRA_THERMAL_LOAD_ANGLE_IMPL_H
#define UMBRA_THERMAL_LOAD_ANGLE_IMPL_H

#include "irradiation/loads.h"
#include "thermal/surface_law.h"

/* Absorptance of the direct sunlight at entry `at`, row * nsurface + surface, of the table, over
 * that at normal incidence [1]; over a turn its mean by what falls in. */
double um_thermal_load_angle(const struct um_thermal_surface_law *law,
                             const struct um_irradiation_loads *loads, size_t at);
#endif
