/* Thin ice cloud above the station: depth' = depth + d at 0.55 um. It takes as much of every colour
 * of the visible, nearly as much in 8-12 um, and glows there. */
#include "effects/list_impl.h"

UM_EFFECT_ON_SKY(add, sky->cirrus += use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "depth",
     .unit = "1",
     .help = "optical depth in the zenith at 0.55 um, beside the scenario's",
     .null_value = 0.0,
     .default_value = 0.1,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.15,
     .prior = "below 0.03 it cannot be seen, from 0.3 on it is no longer thin (Sassen & Cho 1992)"},
};

const struct um_effect um_effects_cirrus = {
    UM_EFFECT_ABI,
    .name = "cirrus",
    .summary = "Thin ice cloud takes as much of every colour, and glows in the infrared",
    .reference = "Baum et al. 2014, J. Quant. Spectrosc. Radiat. Transf. 146:123; Sassen & Cho "
                 "1992, J. Appl. Meteorol. 31:1275",
    .validity = "where observer.air states a profile, not a file; even over the sky and constant "
                "over the observations; crystals of 20 um effective radius",
    .separated_by = "zero_point and extinction: both bands over a range of airmasses; aerosol: two "
                    "colours; a radiometer of the sky at 10 um",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.sky = add},
};
