/* What of the sky depends on time alone: the Earth's pole and the Earth's way about the Sun. */
#ifndef UMBRA_ORBIT_EPHEMERIS_H
#define UMBRA_ORBIT_EPHEMERIS_H

#include "base/core/context.h"

/* Celestial intermediate pole, IAU 2006/2000A: its coordinates in GCRS and the origin's locator. */
struct um_orbit_cip {
  double x, y, s; /* [rad] */
};

/* The Earth's centre, GCRS axes. */
struct um_orbit_earth_motion {
  double r[3];   /* from the Sun [au] */
  double v[3];   /* relative to the Sun [au/d] */
  double v_b[3]; /* relative to the barycentre of the solar system [au/d] */
};

/* The series at nodes of an hour, which are kept, with cubics between them. What is asked first
 * has no say in the answer. May be asked by several threads. */
struct um_orbit_ephemeris;

/* Empty. Out: the caller destroys. UM_ERR_MEMORY. */
enum um_status um_orbit_ephemeris_create(struct um_context *context,
                                         struct um_orbit_ephemeris **out);
/* Accepts NULL, sets NULL. */
void um_orbit_ephemeris_destroy(struct um_context *context, struct um_orbit_ephemeris **ephemeris);

/* Both by ERFA's series (eraXys06a, eraEpv00), TDB taken as TT. ephemeris NULL: the series
 * themselves; else within 1e-14 rad, 1e-13 au and 1e-14 au/d of them. Do not fail in 1900-2100. */
void um_orbit_ephemeris_cip(struct um_orbit_ephemeris *ephemeris, double t_tai,
                            struct um_orbit_cip *out);
void um_orbit_ephemeris_earth(struct um_orbit_ephemeris *ephemeris, double t_tai,
                              struct um_orbit_earth_motion *out);

#endif
