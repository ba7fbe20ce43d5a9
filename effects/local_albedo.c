/* The albedo of a part of the Earth, a' = a (1 + w (f - 1)): cloud, ice or ocean under the orbit.
 * The part is environment.earth.local; unless stated, it is what is below from the start on, as
 * against the orbits before. */
#include "effects/list_impl.h"

UM_EFFECT_ON_ENVIRONMENT(scale, environment->region.albedo_factor *= use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the albedo of that part of the Earth, in heat loads and in earthshine",
     .null_value = 1.0,
     .default_value = 1.5,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.5,
     .prior = "0.1 over ocean to 0.8 over ice and cloud, 0.3 in the mean",
     .formerly = "local_albedo_factor"},
};

const struct um_effect um_effects_local_albedo = {
    UM_EFFECT_ABI,
    .name = "local_albedo",
    .summary = "A part of the Earth, or the Earth from a time on, reflects more or less sunlight",
    .reference = "Anderson, Justus & Batts 2001, NASA/TM-2001-211221",
    .validity =
        "the part is environment.earth.local, with edges of hundreds of kilometres; from the "
        "start of the observations on where it is not stated; no place above an albedo of 1",
    .separated_by =
        "albedo_level, which acts in the orbits before too: temperatures of what stores "
        "heat, or light from before and after the place is passed",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = scale},
};
