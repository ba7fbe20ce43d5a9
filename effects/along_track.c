/* Along-track error: the satellite is where its orbit has it a moment later. Its attitude, the Sun
 * and the station keep their time, which separates it from time_tag. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "shift_s",
     .unit = "s",
     .help = "time by which the satellite is ahead of its orbit",
     .null_value = 0.0,
     .default_value = 1.0,
     .minimum = -100.0,
     .maximum = 100.0,
     .prior_sigma = 5.0,
     .prior = "0.1 to 10 s with elements two weeks old"},
};

static double shift(const struct um_effect_use *use) { return use->value[0]; }

const struct um_effect um_effects_along_track = {
    UM_EFFECT_ABI,
    .name = "along_track",
    .summary = "The satellite runs ahead of its orbit or behind it",
    .reference = "Levit & Marshall 2011, Adv. Space Res. 47:1107",
    .validity = "a constant time; of no effect on a fixed point; laws that follow the orbital "
                "frame follow the satellite",
    .separated_by = "time_tag: positions against stars in the same frames, with frames timed by "
                    "GNSS; the orbit moves range, direction and the shadow, not attitude and stars",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.along_track = shift},
};
