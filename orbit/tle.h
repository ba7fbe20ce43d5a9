/* Element sets of SGP4, and two lines that hold one. */
#ifndef UMBRA_ORBIT_TLE_H
#define UMBRA_ORBIT_TLE_H

#include "base/core/context.h"

struct um_orbit_tle {
  int catalogue_number; /* Alpha-5 decoded */
  char designator[16];  /* 02009A; of a message 2002-009A */
  double epoch_tai;     /* [s] t_tai */
  double epoch_jd[2];   /* UTC Julian date as printed [d] */
  double mean_motion;   /* [rad/min] */
  double mean_motion_dot,
      mean_motion_ddot; /* as printed [rev/day^2 / 2, rev/day^3 / 6]; unused by SGP4 */
  double bstar;         /* [1/Earth radii] */
  double inclination, raan, eccentricity, argument_of_perigee, mean_anomaly; /* [rad], [1] */
};

/* Sets of one object, rising in epoch (orbit/elements.h). */
struct um_orbit_elements {
  struct um_orbit_tle *set; /* [count] */
  size_t count;
};

/* Two or three lines (a name line is skipped). Checks: 69 columns, line numbers, equal catalogue
 * numbers, checksums, every field's range. UM_ERR_INPUT: "TLE line 2: checksum is 5, the line
 * says 4"; `checksum` false skips only the checksum (verification sets have bad ones). */
enum um_status um_orbit_tle_parse(struct um_context *context, const char *text, int checksum,
                                  struct um_orbit_tle *out);

/* Standard deviation of SGP4's place at a time [m], nearly all along the track, from published
 * figures of low orbits and the set's own drag (tle_error.c). NaN: not known, for a period of 225
 * min or more, or where 15 % more drag brings the satellite down before. UM_ERR_INPUT for elements
 * that SGP4 refuses. */
enum um_status um_orbit_tle_error(struct um_context *context, const struct um_orbit_tle *tle,
                                  double t_tai, double *error);

#endif
