/* The infrared of a part of the Earth: OLR' = OLR (1 + w (f - 1)), T_b' = T_b + w d; deserts and
 * cloud under the orbit. The part is environment.earth.local; unless stated, it is what is below
 * from the start on, as against the orbits before. */
#include "effects/list_impl.h"

UM_EFFECT_ON_ENVIRONMENT(change, environment->region.longwave_factor *= use->value[0];
                         environment->region.brightness_shift += use->value[1])

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the outgoing longwave radiation of that part of the Earth",
     .null_value = 1.0,
     .default_value = 0.8,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.2,
     .prior = "130 W/m^2 over high cloud to 310 over desert, 237 in the mean",
     .formerly = "local_olr_factor"},
    {.name = "shift_K",
     .unit = "K",
     .help = "added to its brightness temperature in the band, which the satellite reflects",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -120.0,
     .maximum = 80.0,
     .prior_sigma = 25.0,
     .prior = "210 K over high cloud to 310 K over desert",
     .formerly = "local_brightness_shift_K"},
};

const struct um_effect um_effects_local_earth_ir = {
    UM_EFFECT_ABI,
    .name = "local_earth_ir",
    .summary = "A part of the Earth, or the Earth from a time on, radiates more or less heat",
    .reference = "Anderson, Justus & Batts 2001, NASA/TM-2001-211221",
    .validity =
        "the part is environment.earth.local, with edges of hundreds of kilometres; from the "
        "start of the observations on where it is not stated",
    .separated_by = "earth_ir_level and earth_brightness, which act in the orbits before too: "
                    "temperatures of what stores heat, or light from before and after the place is "
                    "passed",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = change},
};
