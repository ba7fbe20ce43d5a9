/* What the air holds by height, and its climatology by latitude. */
#ifndef UMBRA_ENVIRONMENT_LIMB_PROFILE_H
#define UMBRA_ENVIRONMENT_LIMB_PROFILE_H

enum um_environment_limb_constituent {
  UM_LIMB_AIR, /* scatters as molecules do */
  UM_LIMB_OZONE,
  UM_LIMB_HAZE,    /* aerosol of the troposphere */
  UM_LIMB_AEROSOL, /* aerosol of the stratosphere */
  UM_LIMB_CONSTITUENTS
};

/* Zones of either hemisphere, of which what lies between is a mixture: up to 15 deg, at 45 deg, and
 * from 60 deg on. */
enum um_environment_limb_zone { UM_LIMB_TROPICAL, UM_LIMB_MIDDLE, UM_LIMB_HIGH, UM_LIMB_ZONES };

/* Refractivity n - 1 at 0.55 um [1] and densities of the constituents [any unit] at a height [m].
 */
struct um_environment_limb_profile {
  double (*refractivity)(const void *self, double height);
  double (*density)(const void *self, enum um_environment_limb_constituent which, double height);
  const void *self;
};
/* The US Standard Atmosphere, with the ozone of a zone and aerosols as limb_profile.c says. Nothing
 * is owned. Test: environment/limb_profile. */
struct um_environment_limb_profile um_environment_limb_standard(enum um_environment_limb_zone zone);

/* What a place has of each zone, by its latitude [rad] of either sign; sum 1 [1]. */
void um_environment_limb_zones(double latitude, double share[UM_LIMB_ZONES]);

/* Annual mean of the vertical column of ozone in a zone [Dobson units], and height of the clouds'
 * tops there [m], at which half of all rays that pass over the limb are hidden. */
double um_environment_limb_zone_ozone(enum um_environment_limb_zone zone);
double um_environment_limb_zone_cloud(enum um_environment_limb_zone zone);

#endif
