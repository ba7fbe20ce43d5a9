/* Private to thermal/loads/: the Earth as the body's cube of directions has it. */
#ifndef UMBRA_IRRADIATION_MIRRORED_IMPL_H
#define UMBRA_IRRADIATION_MIRRORED_IMPL_H

#include "environment/environment.h"
#include "environment/timeline.h"

/* weight times the radiances of every cell, added to albedo and planet [UM_GEOMETRY_SKY_CELLS];
 * middle: their directions. */
void um_irradiation_mirrored_earth(const struct um_environment *environment,
                                   const struct um_environment_sample *sample, double weight,
                                   const struct um_vec3 *middle, float *albedo, float *planet);

#endif
