/* Sunlight that the air of the limb scatters to a satellite in the Earth's shadow. */
#ifndef UMBRA_ENVIRONMENT_UMBRA_SCATTER_H
#define UMBRA_ENVIRONMENT_UMBRA_SCATTER_H

#include "environment/environment.h"

#define UM_UMBRA_SCATTER_WAVES 13
#define UM_UMBRA_SCATTER_SUNS  21
#define UM_UMBRA_SCATTER_TURNS 4
/* By air and by aerosol, whose phase functions differ. */
#define UM_UMBRA_SCATTER_KINDS 2

/* Shortest and longest wavelength that is scattered [m]. */
#define UM_UMBRA_SCATTER_SHORTEST 0.30e-6
#define UM_UMBRA_SCATTER_LONGEST  2.00e-6
/* Of sunlight at 0.55 um; starlight and airglow, which are left out, are as much (1e-8 of sunlight
 * on a surface: Leinert et al. 1998, A&AS 127:1) [1]. */
#define UM_UMBRA_SCATTER_ASKED 0.55e-6 /* [m] */
#define UM_UMBRA_SCATTER_LEAST 1e-8

/* Lines of sight over the limb of one air; never written afterwards. */
struct um_environment_umbra_scatter {
  /* what it was made of: of each constituent, [m], and of the shadow [m] */
  double amount[4], cloud_top, radius;
  /* ln of the radiance that light scattered once has over the lamp's irradiance, without its phase
   * function, summed over tangent heights [m]: by zenith angle of the Sun at the tangent point and
   * by the cosine of the azimuth of the line of sight from it */
  double once[UM_UMBRA_SCATTER_KINDS][UM_UMBRA_SCATTER_WAVES][UM_UMBRA_SCATTER_SUNS]
             [UM_UMBRA_SCATTER_TURNS];
};

/* Of the air that the environment states for the edge of the shadow, of middle latitudes where it
 * states none; environment->limb is wanted, and not kept. Some 30 ms. UM_ERR_MEMORY; the caller
 * frees *out with um_core_free. */
enum um_status um_environment_umbra_scatter_make(struct um_context *context,
                                                 const struct um_environment *environment,
                                                 struct um_environment_umbra_scatter **out);
/* Would um_environment_umbra_scatter_make give the same? The limb's air is not looked at. */
bool um_environment_umbra_scatter_is_of(const struct um_environment_umbra_scatter *scatter,
                                        const struct um_environment *environment);

/* Scattered light at one place: ln of the share of sunlight [1] by wavelength; none: it is less
 * than UM_UMBRA_SCATTER_LEAST. */
struct um_environment_scattered {
  bool any;
  double share[UM_UMBRA_SCATTER_WAVES];
};
/* Arguments of um_environment_sunlit_fraction. Its result is the irradiance on a surface that faces
 * the Sun, over that of the unshadowed Sun; with lit, the share of sunlight that arrives there, it
 * is times 1 - lit, so that it ends where the shadow does. None without environment->umbra_scatter,
 * nor without the air that shadow_refraction stands for. Light scattered once;
 * docs/physics/shadow.md has what holds it. Test: environment/umbra_scatter. */
void um_environment_umbra_scattered(const struct um_environment *environment, struct um_vec3 r,
                                    struct um_vec3 sun, double distance, struct um_vec3 pole,
                                    double lit, struct um_environment_scattered *out);
/* Share of sunlight at a wavelength [m]; 0 outside the wavelengths that are scattered [1]. */
double um_environment_scattered_at(const struct um_environment_scattered *scattered,
                                   double wavelength);
#endif
