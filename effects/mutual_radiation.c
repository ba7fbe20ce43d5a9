/* Infrared between the surfaces of the satellite, J = eps sigma T^4 + (1 - eps) H, H what arrives
 * of the Earth and of all J (thermal/exchange/exchange.h). Without it, what is emitted toward the
 * satellite itself is taken to come back to where it left (model/build/build_blocked.c). */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->mutual_radiation_on = false)

const struct um_effect um_effects_mutual_radiation = {
    UM_EFFECT_ABI,
    .name = "mutual_radiation",
    .summary = "Surfaces of the satellite heat each other by their thermal radiation",
    .reference = "Gebhart 1961, Int. J. Heat Mass Transfer 3:341; Hottel & Sarofim 1967",
    .validity = "diffuse surfaces, all orders of reflection, what is absorbed by emittances at the "
                "temperature of what arrives, mean over the orbit; inside closed parts with "
                "inside_emittance too; nothing else on a convex satellite",
    .separated_by =
        "internal_power and emittance: a surface that looks at another follows the "
        "other's temperature through the orbit; a joint that turns the two apart ends it",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
