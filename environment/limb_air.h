/* What sunlight meets that passes close over the Earth: by how much it is bent, and through how
 * much air, ozone and aerosol it goes, by the height of its lowest point. */
#ifndef UMBRA_ENVIRONMENT_LIMB_AIR_H
#define UMBRA_ENVIRONMENT_LIMB_AIR_H

#include "environment/limb_profile.h"

#define UM_LIMB_NODES 201
#define UM_LIMB_STEP  500.0 /* [m] between them */

/* Over k UM_LIMB_STEP, 0 to 100 km: heights of the lowest points of straight rays, or impact
 * heights n r - R of bent ones, n r at the lowest point, which are those of their straight
 * continuation. */
struct um_environment_limb_air {
  double height[UM_LIMB_NODES];  /* of the lowest point [m]; below 0: the ground is in the way */
  double bending[UM_LIMB_NODES]; /* at 0.55 um [rad] */
  /* columns along the whole ray over the vertical column from the ground up [1] */
  double column[UM_LIMB_CONSTITUENTS][UM_LIMB_NODES];
};

/* Straight rays through the profile over a sphere of this radius [m]: columns 2 int n ds, bending
 * the change of the optical path with height. About 20 ms. Test: environment/limb_air. */
void um_environment_limb_air_make(const struct um_environment_limb_profile *profile, double radius,
                                  struct um_environment_limb_air *out);

/* The same of bent rays, exact for a round air; by impact height. Test: environment/limb_air. */
void um_environment_limb_air_bent(const struct um_environment_limb_profile *profile, double radius,
                                  struct um_environment_limb_air *out);

/* Bending at a wavelength [m] over that at 0.55 um [1]: as the refractivity of air. */
double um_environment_limb_dispersion(double wavelength);

/* Vertical optical depth of each constituent at a wavelength [m], per unit of what the environment
 * states: air of one standard atmosphere; ozone of one Dobson unit; aerosols of depth 1 at 0.55 um.
 * Rayleigh: Bodhaine et al. 1999, J. Atmos. Oceanic Technol. 16:1854, eq. 30. Ozone: cross-sections
 * at 233 K of Serdyuchenko et al. 2014, Atmos. Meas. Tech. 7:625, in means over 20 nm. */
void um_environment_limb_depth(double wavelength, double depth[UM_LIMB_CONSTITUENTS]);

#endif
