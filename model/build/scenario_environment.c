/* The scenario's environment in SI, without what effects do to it. */
#include "model/build/steps_impl.h"

void um_model_scenario_environment(const struct um_scenario *scenario, struct um_environment *to)
{
  const struct um_scenario_environment *from = scenario->environment;
  um_environment_defaults(to);
  to->inter_reflection_on = scenario->optics->interreflection_samples > 0;
  to->solar_irradiance = from->solar_irradiance_W_m2;
  to->spectrum = (enum um_environment_spectrum)from->solar_spectrum;
  to->solar_temperature = from->solar_temperature_K;
  if (from->earth != NULL) to->earth = (enum um_environment_earth)from->earth->model;
  to->albedo = from->albedo;
  to->outgoing_longwave = from->olr_W_m2;
  to->brightness_temperature = from->brightness_temperature_K;
  to->earth_radius = from->earth_radius_km * 1e3;
  to->shadow = (enum um_environment_shadow)from->shadow;
  to->shadow_radius = from->shadow_radius_km * 1e3;
  to->disc = (enum um_environment_disc)from->disc;
  to->limb_darkening = from->limb_darkening;
  if (from->shadow_air != NULL) {
    to->ozone_dobson = from->shadow_air->ozone_DU;
    to->haze = from->shadow_air->haze;
    to->aerosol = from->shadow_air->stratospheric_aerosol;
    to->cloud_top = from->shadow_air->cloud_top_km * 1e3;
  }
}
