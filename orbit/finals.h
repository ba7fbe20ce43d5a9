/* Where the Earth's pole is and how far it has turned. */
#ifndef UMBRA_ORBIT_FINALS_H
#define UMBRA_ORBIT_FINALS_H

#include "base/core/context.h"
#include "orbit/ephemeris.h"

/* Earth orientation: constant values, or a table from an IERS finals2000A file. */
struct um_orbit_earth_orientation {
  double ut1_utc;                 /* [s] */
  double xp, yp;                  /* pole [rad] */
  struct um_orbit_finals *finals; /* NULL: the constants above hold; owned by whoever read it */
  struct um_orbit_ephemeris *ephemeris; /* precession and nutation, NULL: their series; borrowed */
};

/* Read an IERS finals2000A.all/daily file (fixed columns). UM_ERR_IO, UM_ERR_INPUT with the line.
 */
enum um_status um_orbit_finals_read(struct um_context *context, const char *path,
                                    struct um_orbit_finals **out);
void um_orbit_finals_destroy(struct um_orbit_finals **finals);
/* Values at a time: constants, or linear in the table (UT1-UTC across a leap second by UT1-TAI).
 * UM_ERR_INPUT outside the table. */
enum um_status um_orbit_earth_orientation_at(struct um_context *context,
                                             const struct um_orbit_earth_orientation *orientation,
                                             double t_tai, double *ut1_utc, double *xp, double *yp);

#endif
