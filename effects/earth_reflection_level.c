/* Level of the Earth's own radiation that the satellite reflects to the observer. Its thermal twin
 * is the Earth-IR load, which stays. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the reflected radiation of the Earth",
     .null_value = 1.0,
     .default_value = 0.9,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.3,
     .prior = "220 to 290 K of brightness temperature"},
};

UM_EFFECT_ON_ENVIRONMENT(environment, environment->earth_reflection_factor *= use->value[0])

const struct um_effect um_effects_earth_reflection_level = {
    UM_EFFECT_ABI,
    .name = "earth_reflection_level",
    .summary = "The Earth seen in the satellite is warmer or colder than modelled",
    .reference = "Catsamas et al. 2025, arXiv 2511.13030",
    .validity = "optics only, heat loads stay; of no effect where reflected_earth_ir is off",
    .separated_by = "internal_power and emittance: thermal infrared of sides that face the Earth "
                    "changes at once with the ground below while their temperature stays; "
                    "earth_brightness is the same thing in one band",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = environment},
};
