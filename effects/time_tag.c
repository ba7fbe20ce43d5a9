/* Clock of the observer: tag = true time + bias. Everything is observed at tag - bias: the edges of
 * the eclipse, the attitude and the stars all move together. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "shift_s",
     .unit = "s",
     .help = "tag minus true time",
     .null_value = 0.0,
     .default_value = 0.1,
     .minimum = -100.0,
     .maximum = 100.0,
     .prior_sigma = 1.0,
     .prior = "1 ms to 1 s without a disciplined clock",
     .formerly = "bias_s"},
};

static double true_time(const struct um_effect_use *use, double t_tai)
{
  return t_tai - use->value[0];
}

const struct um_effect um_effects_time_tag = {
    UM_EFFECT_ABI,
    .name = "time_tag",
    .summary = "The clock of the observations is wrong by a constant",
    .reference = "Montenbruck & Gill 2000, Satellite Orbits, chapter 6",
    .validity = "constant over all observations",
    .separated_by =
        "along_track: stars in the same frames, or the edges of an eclipse beside glints; a clock "
        "moves everything alike, an orbit does not move attitude and stars",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.time = true_time},
};
