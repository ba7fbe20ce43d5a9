/* GeographicLib behind C. Angles [rad], lengths [m], WGS-84. */
#ifndef UMBRA_ORBIT_GEODESY_H
#define UMBRA_ORBIT_GEODESY_H

#ifdef __cplusplus
extern "C" {
struct um_vec3 { /* as in base/core/vec.h, whose inline functions are C only */
  double x, y, z;
};
#else
#include "base/core/vec.h"
#endif
/* Geodetic -> ITRF. Does not fail for finite input. */
struct um_vec3 um_orbit_geodesy_forward(double latitude, double longitude, double height);
/* ITRF -> geodetic. */
void um_orbit_geodesy_reverse(struct um_vec3 r_itrf, double *latitude, double *longitude,
                              double *height);
/* East, north, up of an ITRF point as seen from a geodetic origin [m]. */
struct um_vec3 um_orbit_geodesy_enu(double latitude, double longitude, double height,
                                    struct um_vec3 r_itrf);
/* The inverse: ITRF of a point that stands at `enu` [m] from a geodetic origin. */
struct um_vec3 um_orbit_geodesy_from_enu(double latitude, double longitude, double height,
                                         struct um_vec3 enu);
#ifdef __cplusplus
}
#endif

#endif
