/* What sunlight meets that passes close over the Earth: by how much it is bent, and through how
 * much air, ozone and aerosol it goes, by the height of its lowest point. */
#ifndef UMBRA_ENVIRONMENT_LIMB_AIR_H
#define UMBRA_ENVIRONMENT_LIMB_AIR_H

#include "base/core/context.h"

#define UM_LIMB_NODES 201
#define UM_LIMB_STEP  500.0 /* [m] between them */

enum um_environment_limb_constituent {
  UM_LIMB_AIR, /* scatters as molecules do */
  UM_LIMB_OZONE,
  UM_LIMB_HAZE,    /* aerosol of the troposphere */
  UM_LIMB_AEROSOL, /* aerosol of the stratosphere */
  UM_LIMB_CONSTITUENTS
};

/* Over heights k UM_LIMB_STEP of the lowest point, 0 to 100 km. */
struct um_environment_limb_air {
  double bending[UM_LIMB_NODES]; /* [rad] */
  /* columns along the whole ray over the vertical column from the ground up [1] */
  double column[UM_LIMB_CONSTITUENTS][UM_LIMB_NODES];
};

/* Refractivity n - 1 [1] and densities of the constituents [any unit] at a height [m]. */
struct um_environment_limb_profile {
  double (*refractivity)(const void *self, double height);
  double (*density)(const void *self, enum um_environment_limb_constituent which, double height);
  const void *self;
};
/* The US Standard Atmosphere, ozone and aerosols as limb_air.c says. */
struct um_environment_limb_profile um_environment_limb_standard(void);

/* Straight rays through the profile over a sphere of this radius [m]: columns 2 int n ds, bending
 * the change of the optical path with height. About 20 ms. Test: environment/limb_air. */
void um_environment_limb_air_make(const struct um_environment_limb_profile *profile, double radius,
                                  struct um_environment_limb_air *out);

/* Vertical optical depth of each constituent at a wavelength [m], per unit of what the environment
 * states: air of one standard atmosphere; ozone of one Dobson unit; aerosols of depth 1 at 0.55 um.
 * Rayleigh: Bodhaine et al. 1999, J. Atmos. Oceanic Technol. 16:1854, eq. 30. Ozone: cross-sections
 * at 233 K of Serdyuchenko et al. 2014, Atmos. Meas. Tech. 7:625, in means over 20 nm. */
void um_environment_limb_depth(double wavelength, double depth[UM_LIMB_CONSTITUENTS]);

#endif
