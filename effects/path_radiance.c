/* Heat of the air on the line of sight that was not, or too much, subtracted,
 *   E' = E + b (1 - exp(-tau X)) / (1 - exp(-tau)),
 * an isothermal layer of optical depth tau at the zenith (Chandrasekhar 1960, section 7): in
 * proportion to X where the air is thin, alike at all airmasses where it is thick. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "irradiance_W_m2",
     .unit = "W/m^2",
     .help = "added to the irradiance at the zenith",
     .null_value = 0.0,
     .default_value = 1e-12,
     .minimum = -1e-3,
     .maximum = 1e-3,
     .prior_sigma = INFINITY,
     .prior = "a share of the sky's heat that depends on how it is subtracted: none"},
    {.name = "depth",
     .unit = "1",
     .help = "of the air at the zenith",
     .null_value = 0.3,
     .default_value = 0.3,
     .minimum = 0.001,
     .maximum = 20.0,
     .prior_sigma = 0.5,
     .logarithmic = true,
     .prior = "8 to 12 um: 0.15 in dry air, 0.7 in humid air",
     .formerly = "optical_depth"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  double tau = use->value[1];
  if (!um_effect_acts_on(use, o->band) || isnan(o->airmass)) return UM_OK;
  o->value += use->value[0] * expm1(-tau * o->airmass) / expm1(-tau);
  return UM_OK;
}

const struct um_effect um_effects_path_radiance = {
    UM_EFFECT_ABI,
    .name = "path_radiance",
    .summary = "Heat of the air on the line of sight is left in what is measured",
    .reference = "Chandrasekhar 1960, Radiative Transfer, section 7",
    .validity = "air of one temperature; acts on irradiance, counts, measured radiant intensity "
                "and magnitude (there the same at every wavelength) in the order of the list of "
                "effects; of no effect without a station",
    .separated_by = "background and extinction: frames beside the satellite at several airmasses; "
                    "what is added does not grow with the satellite's light",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
