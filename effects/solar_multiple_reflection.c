/* Sunlight, from the Sun and by way of the Earth, that surfaces reflect to each other as heat,
 * H = E + F rho H with rho = 1 - alpha (thermal/exchange/exchange.h). Its optical twin is
 * inter_reflection. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->solar_reflection_on = false)

const struct um_effect um_effects_solar_multiple_reflection = {
    UM_EFFECT_ABI,
    .name = "solar_multiple_reflection",
    .summary = "Sunlight that surfaces of the satellite reflect to each other heats them",
    .reference = "Gebhart 1961, Int. J. Heat Mass Transfer 3:341; Hottel & Sarofim 1967",
    .validity = "diffuse reflection of 1 - absorptance, all orders; reflected sunlight on cells is "
                "heat alone; nothing on a convex satellite",
    .separated_by = "solar_absorptance and panel_extraction: a surface in the shade of the "
                    "satellite warms when a bright one before it is lit",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
