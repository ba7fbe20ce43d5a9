/* Zero point: a constant factor of what is measured, throughput and calibration together. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "measured by true irradiance",
     .null_value = 1.0,
     .default_value = 0.9,
     .minimum = 0.01,
     .maximum = 100.0,
     .prior_sigma = 0.7,
     .logarithmic = true,
     .prior = "throughput of a new setup, known to a factor of 2"},
};

UM_EFFECT_ON_OBSERVATION(observation, o->value *= use->value[0])

const struct um_effect um_effects_zero_point = {
    UM_EFFECT_ABI,
    .name = "zero_point",
    .summary = "The calibration of a band is off by a factor",
    .reference = "Bessell 2005, Annu. Rev. Astron. Astrophys. 43:293",
    .validity =
        "constant over all observations; acts on irradiance, magnitude and measured radiant "
        "intensity in the order of the list of effects",
    .separated_by = "area, diffuse_level and extinction: standard stars in the same night, or a "
                    "second band of the same part that the factor does not touch",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
