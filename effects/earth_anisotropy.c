/* Sunlight that the Earth reflects is not the same toward all sides: the sea glints, cloud sends
 * more toward the mirrored Sun and toward the limb, land sends more back (environment/daylight.h).
 * Without it every place is a Lambert surface of its albedo. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_SWITCH(switch_off, environment->earth_anisotropy_on = false)

const struct um_effect um_effects_earth_anisotropy = {
    UM_EFFECT_ABI,
    .name = "earth_anisotropy",
    .summary = "Sunlight that sea, land, snow and cloud of the Earth reflect goes by angle",
    .reference = "Cox & Munk 1954; Rahman, Pinty & Verstraete 1993; Hansen 1971",
    .validity =
        "where environment.earth.model is not uniform; the albedo stays; at 0.55 um for all "
        "wavelengths; cloud is flat, and of the mean cover of its place",
    .separated_by = "albedo_level and earthshine_level, which are one for all angles: earthlight "
                    "of the same plates with the Sun high, and with the Sun low before and behind",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
