/* The Earth's main magnetic field: low degrees of the International Geomagnetic Reference Field. */
#ifndef UMBRA_ORBIT_MAGNETIC_FIELD_H
#define UMBRA_ORBIT_MAGNETIC_FIELD_H

#include "base/core/vec.h"

#define UM_MAGNETIC_DEGREE 4 /* highest that is kept */

/* Flux density [T] at a place r [m] of the Earth-fixed frame (ITRF), outside the Earth, degrees 1
 * to `degree` (1: the tilted dipole; up to UM_MAGNETIC_DEGREE). Coefficients of IGRF-14, linear
 * between its epochs from 1960.0 to 2030.0, the last of them its prediction; held beyond. Against
 * all 13 degrees the direction is off by 1.2 deg rms and 3.9 at most, at 600 km; test:
 * orbit/magnetic_field.
 */
struct um_vec3 um_orbit_magnetic_field(double t_tai, struct um_vec3 r_itrf, int degree);

#endif
