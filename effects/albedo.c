/* Albedo as a heat load: q = alpha int a S max(cos SZA, 0) cos(theta) cos(theta_E) / (pi d^2) dA
 * over the visible cap. Its optical twin is earthshine. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->albedo_on = false)

const struct um_effect um_effects_albedo = {
    UM_EFFECT_ABI,
    .name = "albedo",
    .summary = "Sunlight reflected by the Earth heats the satellite",
    .reference = "Knocke, Ries & Tapley 1988, AIAA 88-4292",
    .validity = "Earth of the scenario's albedo or of earth_map; acts on both sides of the "
                "terminator",
    .separated_by = "solar_absorptance, which heats in the Sun alone: temperatures of a side that "
                    "faces the Earth, followed past the terminator of the ground below",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
