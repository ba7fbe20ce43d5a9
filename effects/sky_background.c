/* Sky that was not, or too much, subtracted: light of a thin layer that glows, longer in sight
 * toward the horizon,
 *   E' = E + b V,   V = (1 - (R sin z / (R + h))^2)^(-1/2)  (van Rhijn 1921),   h = 90 km. */
#include "base/core/constants.h"
#include "effects/list_impl.h"

#define AIRGLOW 90e3 /* height of the layer [m] */

static const struct um_effect_parameter parameters[] = {
    {.name = "irradiance_W_m2",
     .unit = "W/m^2",
     .help = "added to the irradiance at the zenith",
     .null_value = 0.0,
     .default_value = 1e-12,
     .minimum = -1e-3,
     .maximum = 1e-3,
     .prior_sigma = INFINITY,
     .prior = "depends on the instrument and the site: none"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  if (!um_effect_acts_on(use, o->band) || isnan(o->airmass)) return UM_OK;
  double sine = UM_EARTH_RADIUS / (UM_EARTH_RADIUS + AIRGLOW) * cos(o->elevation);
  o->value += use->value[0] / sqrt(1.0 - sine * sine);
  return UM_OK;
}

const struct um_effect um_effects_sky_background = {
    UM_EFFECT_ABI,
    .name = "sky_background",
    .summary = "Light of the night sky is left in what is measured, more toward the horizon",
    .reference = "van Rhijn 1921, Publ. Kapteyn Lab. Groningen 31; Roach & Gordon 1973, The Light "
                 "of the Night Sky",
    .validity = "airglow, a dark site without Moon and twilight; acts on irradiance, counts, "
                "measured radiant intensity and magnitude (there the same at every wavelength) in "
                "the order of the list of effects; of no effect without a station",
    .separated_by = "background and path_radiance: frames beside the satellite along its path, or "
                    "in the satellite's eclipse, where little else is left in the visible",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
