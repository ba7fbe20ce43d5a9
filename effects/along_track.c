/* Along-track error: the satellite is where its orbit has it a moment later. Its attitude, the Sun
 * and the station keep their time, which separates it from time_tag. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {"shift_s", "s", "time by which the satellite is ahead of its orbit", 0.0, 1.0, -100.0, 100.0,
     5.0},
};

static double shift(const struct um_effect_use *use) { return use->value[0]; }

const struct um_effect um_effects_along_track = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "along_track",
    .summary = "The satellite runs ahead of its orbit or behind it",
    .reference = "Levit & Marshall 2011, Adv. Space Res. 47:1107",
    .validity = "a constant time; of no effect on a fixed point; laws that follow the orbital "
                "frame follow the satellite",
    .targets = UM_TARGET_GLOBAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.along_track = shift},
};
