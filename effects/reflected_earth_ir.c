/* Reflected Earth radiation: L_o = (1 - epsilon_lambda(theta_o)) F B_lambda(T_Earth). For bare
 * metal it is an order of magnitude above the metal's own emission. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->earth_reflection_on = false)

const struct um_effect um_effects_reflected_earth_ir = {
    UM_EFFECT_ABI,
    .name = "reflected_earth_ir",
    .summary = "Thermal radiation of the Earth reflected by the satellite reaches the observer",
    .reference = "Kirchhoff's law; Catsamas et al. 2025, arXiv 2511.13030",
    .validity =
        "Earth of one brightness temperature in the band; the satellite reflects it diffusely",
    .separated_by =
        "earth_ir and internal_power: thermal infrared of bare metal follows the share of the "
        "Earth in the sky of the side that is seen, at once, while temperatures stay",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
