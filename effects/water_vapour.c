/* Water vapour above the station: w' = f w. In 8-12 um it decides what arrives; in the visible it
 * takes 1 %. */
#include "effects/list_impl.h"

UM_EFFECT_ON_SKY(scale, sky->water *= use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the scenario's precipitable water",
     .null_value = 1.0,
     .default_value = 2.0,
     .minimum = 0.02,
     .maximum = 10.0,
     .prior_sigma = 0.5,
     .logarithmic = true,
     .prior = "day-to-day scatter about a season's mean at mid-latitudes",
     .formerly = "water_factor"},
};

const struct um_effect um_effects_water_vapour = {
    UM_EFFECT_ABI,
    .name = "water_vapour",
    .summary = "There is more or less water above the station than stated",
    .reference = "Roberts, Selby & Biberman 1976, Appl. Opt. 15:2085",
    .validity = "where observer.air states a profile, not a file; constant over the observations",
    .separated_by = "zero_point and extinction of an infrared band, emittance: a range of "
                    "airmasses, since it grows less than they do; a radiosonde or GPS receiver",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.sky = scale},
};
