/* GeographicLib behind C: the Earth's main magnetic field, by IGRF (the International Geomagnetic
 * Reference Field). */
#ifndef UMBRA_ORBIT_MAGNETIC_FIELD_H
#define UMBRA_ORBIT_MAGNETIC_FIELD_H

#define UM_MAGNETIC_DEGREE 13 /* all that IGRF has */

#ifdef __cplusplus
extern "C" {
struct um_vec3 { /* as in base/core/vec.h, whose inline functions are C only */
  double x, y, z;
};
#else
#include "base/core/vec.h"
#endif
/* Flux density [T] at a place r [m] of the Earth-fixed frame (ITRF), outside the Earth, degrees 1
 * to `degree` (1: the tilted dipole; up to UM_MAGNETIC_DEGREE). Coefficients of IGRF-14, linear
 * between its epochs from 1960.0 to 2030.0, the last of them its prediction; held beyond. Within
 * 1 nT of other programs; test: orbit/magnetic_field. */
struct um_vec3 um_orbit_magnetic_field(double t_tai, struct um_vec3 r_itrf, int degree);
#ifdef __cplusplus
}
#endif

#endif
