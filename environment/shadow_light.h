/* Sunlight where the Earth's air bends, scatters and absorbs it: at the edge of the shadow. */
#ifndef UMBRA_ENVIRONMENT_SHADOW_LIGHT_H
#define UMBRA_ENVIRONMENT_SHADOW_LIGHT_H

#include "environment/environment.h"
#include "environment/limb_air.h"

#define UM_LIMB_BANDS 24

/* What sunlit fractions need of the air, for one environment; never written afterwards. */
struct um_environment_limb {
  struct um_environment_limb_air straight; /* of middle latitudes, along straight rays */
  struct um_environment_limb_air bent[UM_LIMB_ZONES];
  double share[UM_LIMB_BANDS];                       /* of sunlight by wavelength; sum 1 [1] */
  double depth[UM_LIMB_BANDS][UM_LIMB_CONSTITUENTS]; /* of um_environment_limb_depth [1] */
  double dispersion[UM_LIMB_BANDS];                  /* of um_environment_limb_dispersion [1] */
};
/* The standard air over the radius of the environment's shadow, before its Sun. */
void um_environment_limb_make(const struct um_environment *environment,
                              struct um_environment_limb *out);

/* Share of rays of a lowest height that neither the ground nor clouds of these tops hide, both [m]
 * [1]. */
double um_environment_limb_clear(double cloud_top, double height);

/* The light of the Sun at one place: bundles of rays by the height at which they pass. */
struct um_environment_shadow_light {
  double
      direct; /* share of the disc whose light meets no air, or all of it without refraction [1] */
  size_t count;
  /* of the light of the disc, spread by refraction, not yet dimmed, and what is added to it for
   * each unit that um_environment_limb_dispersion is above 1 [1] */
  double share[UM_LIMB_NODES], slope[UM_LIMB_NODES];
  double depth[UM_LIMB_CONSTITUENTS][UM_LIMB_NODES]; /* column times what is stated of it [1] */
};

/* Arguments of um_environment_sunlit_fraction. direct is 1 in full sunlight; in the full shadow it
 * is 0, and count is 0. Without environment->limb, behind a cylinder, before a point and from
 * beyond 450 000 km: direct is the sunlit fraction of the bare Earth. */
void um_environment_shadow_light(const struct um_environment *environment, struct um_vec3 r,
                                 struct um_vec3 sun, double distance, struct um_vec3 pole,
                                 struct um_environment_shadow_light *out);

/* Share of the Sun's light that arrives at a wavelength [m], and of all its energy [1]. */
double um_environment_shadow_light_at(const struct um_environment_shadow_light *light,
                                      double wavelength);
double um_environment_shadow_light_mean(const struct um_environment_limb *limb,
                                        const struct um_environment_shadow_light *light);

#endif
