/* Background that was not, or too much, subtracted: a constant irradiance. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "irradiance_W_m2",
     .unit = "W/m^2",
     .help = "added to the irradiance",
     .null_value = 0.0,
     .default_value = 1e-12,
     .minimum = -1e-3,
     .maximum = 1e-3,
     .prior_sigma = INFINITY,
     .prior = "depends on the instrument: none"},
};

UM_EFFECT_ON_OBSERVATION(observation, o->value += use->value[0])

const struct um_effect um_effects_background = {
    UM_EFFECT_ABI,
    .name = "background",
    .summary = "A constant light is left in what is measured",
    .reference = "Howell 2006, Handbook of CCD Astronomy, chapter 5",
    .validity = "constant over all observations; acts on irradiance, measured radiant intensity "
                "and magnitude "
                "(there the same at every wavelength) in the order of the list of effects",
    .separated_by = "earthshine and zero_point: frames beside the satellite; it does not fall with "
                    "range, and counts most where the satellite is faint",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
