/* How much air, ozone and aerosol lies between a point of the atmosphere and space, and what of the
 * Sun's light arrives there. */
#ifndef UMBRA_ENVIRONMENT_SLANT_AIR_H
#define UMBRA_ENVIRONMENT_SLANT_AIR_H

#include <stdbool.h>

#include "environment/limb_air.h"

#define UM_SLANT_TOP       130e3 /* [m] above it nothing is left */
#define UM_SLANT_DENSITIES 651   /* every 200 m up to there */
#define UM_SLANT_HEIGHTS   101   /* every 1 km */
#define UM_SLANT_ANGLES    33    /* cosine of the zenith angle (k/32)^2 */

/* The air of limb_air.h over a sphere, in units of its vertical columns. */
struct um_environment_slant {
  double radius;                             /* [m] */
  const struct um_environment_limb_air *air; /* borrowed: whole rays and their bending */
  double density[UM_LIMB_CONSTITUENTS][UM_SLANT_DENSITIES];           /* [1/m] */
  double up[UM_LIMB_CONSTITUENTS][UM_SLANT_HEIGHTS][UM_SLANT_ANGLES]; /* ln of the column [1] */
};

/* The standard air; `air` was made of it over the same radius [m]. About 20 ms. */
void um_environment_slant_make(const struct um_environment_limb_air *air, double radius,
                               struct um_environment_slant *out);

/* Density at a height [m] over the vertical column [1/m]; 0 above UM_SLANT_TOP. */
double um_environment_slant_density(const struct um_environment_slant *slant,
                                    enum um_environment_limb_constituent which, double height);

/* Columns of a straight ray from a height [m] to space, cosine of its zenith angle 0 or more, over
 * the vertical column from sea level [1]. To 0.6 %; test: environment/slant_air. */
void um_environment_slant_up(const struct um_environment_slant *slant, double height, double cosine,
                             double column[UM_LIMB_CONSTITUENTS]);

/* The Sun's ray to a point, at a true zenith angle there [rad]: columns on it [1], and what
 * refraction leaves of its irradiance, without extinction [1]. False: the Earth is in the way. The
 * Sun is a point. */
bool um_environment_slant_sun(const struct um_environment_slant *slant, double height,
                              double zenith_angle, double column[UM_LIMB_CONSTITUENTS],
                              double *dilution);

#endif
