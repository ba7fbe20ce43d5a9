/* Sun and Moon by ERFA (epv00, moon98), TDB taken as TT. */
#ifndef UMBRA_ORBIT_SUN_H
#define UMBRA_ORBIT_SUN_H

#include "base/core/vec.h"
#include "orbit/ephemeris.h"

/* Geometric geocentric Sun [m], GCRS. ephemeris, here and below: where the Earth is taken from,
 * NULL: the series. Does not fail in 1900-2100. */
struct um_vec3 um_orbit_sun_position(struct um_orbit_ephemeris *ephemeris, double t_tai);
/* Geometric geocentric Moon [m], GCRS, 10 arcsec. */
struct um_vec3 um_orbit_moon_position(double t_tai);
/* Apparent direction (unit, GCRS; light time and aberration by the velocity of the Earth plus
 * v_gcrs) and distance [m] of the Sun from a point r_gcrs [m] with velocity v_gcrs [m/s]. */
void um_orbit_sun_apparent(struct um_orbit_ephemeris *ephemeris, double t_tai,
                           struct um_vec3 r_gcrs, struct um_vec3 v_gcrs, struct um_vec3 *direction,
                           double *distance);

#endif
