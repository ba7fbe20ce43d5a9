/* What smooth surfaces of the satellite reflect goes on along the mirrored ray to its other
 * surfaces, S' in place of S (geometry/mirror_paths.h, thermal/exchange/exchange.h), sunlight and
 * the Earth's light too. Without it they scatter all that they reflect. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->specular_exchange_on = false)

const struct um_effect um_effects_specular_exchange = {
    UM_EFFECT_ABI,
    .name = "specular_exchange",
    .summary = "Smooth surfaces mirror heat and sunlight to other surfaces of the satellite",
    .reference = "Sarofim & Hottel 1966, J. Heat Transfer 88:37; Siegel & Howell 2002, ch. 9",
    .validity =
        "outer surfaces whose lobe has a Beckmann alpha of at most 0.1, taken as a flat mirror "
        "of one reflectance at all angles; blankets that hang in folds scatter more; acts "
        "on what mutual_radiation and solar_multiple_reflection exchange; nothing on a "
        "convex satellite",
    .separated_by = "solar_multiple_reflection and solar_absorptance: a surface warms while it "
                    "stands in the mirror image of the Sun, and not before or after",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
