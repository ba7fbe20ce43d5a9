/* Defaults of the one Sun and the one Earth. */
#include "environment/environment.h"

#include <math.h>

#include "base/core/constants.h"

void um_environment_defaults(struct um_environment *out)
{
  *out = (struct um_environment){
      .solar_irradiance = UM_SOLAR_IRRADIANCE,
      .spectrum = UM_SPECTRUM_E490,
      .solar_temperature = UM_SOLAR_TEMPERATURE,
      .earth = UM_EARTH_UNIFORM,
      .albedo_factor = 1.0,
      .longwave_factor = 1.0,
      .region = {.everywhere = true,
                 .from_tai = -INFINITY,
                 .to_tai = INFINITY,
                 .albedo_factor = 1.0,
                 .longwave_factor = 1.0},
      .albedo = 0.30,             /* Stephens et al. 2012, Nature Geoscience 5:691 */
      .outgoing_longwave = 237.0, /* the same, rounded */
      .earth_spectrum_on = true,
      .earth_anisotropy_on = true,
      .brightness_temperature = 270.0, /* between clear (260-285 K) and cloudy (220-250 K) */
      .earth_radius = UM_EARTH_RADIUS,
      .shadow = UM_SHADOW_OBLATE,
      .shadow_radius = UM_EARTH_RADIUS,
      .disc = UM_DISC_LIMB_DARKENED,
      .limb_darkening = 0.6, /* at 550 nm, Neckel & Labs 1994, Solar Physics 153:91 */
      .shadow_refraction_on = true,
      .umbra_scatter_on = true,
      .air_factor = 1.0,
      .ozone_dobson = NAN,
      .ozone_factor = 1.0,
      .haze = 0.1,      /* between sea and land, Holben et al. 2001, J. Geophys. Res. 106:12067 */
      .aerosol = 0.010, /* of 2017 to 2026, SAGE III: limb_profile.c */
      .cloud_top = NAN,
      .albedo_on = true,
      .planet_on = true,
      .earthshine_on = true,
      .earth_reflection_on = true,
      .moonlight_on = true,
      .earthshine_factor = 1.0,
      .earth_reflection_factor = 1.0,
      .earthlight_lobe_on = true,
      .mutual_radiation_on = true,
      .solar_reflection_on = true,
      .multiple_scattering_on = true,
      .inter_reflection_on = true,
      .specular_exchange_on = true,
      .absorptance_by_angle = true,
      .emittance_by_temperature = true,
      .bulk_by_temperature = true,
  };
}
