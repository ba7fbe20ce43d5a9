/* Clock of the observer: tag = true time + bias. Everything is observed at tag - bias: the edges of
 * the eclipse, the attitude and the stars all move together. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {"bias_s", "s", "tag minus true time", 0.0, 0.1, -100.0, 100.0, 1.0},
};

static double true_time(const struct um_effect_use *use, double t_tai)
{
  return t_tai - use->value[0];
}

const struct um_effect um_effects_time_tag = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "time_tag",
    .summary = "The clock of the observations is wrong by a constant",
    .reference = "Montenbruck & Gill 2000, Satellite Orbits, chapter 6",
    .validity = "constant over all observations",
    .targets = UM_TARGET_GLOBAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.time = true_time},
};
