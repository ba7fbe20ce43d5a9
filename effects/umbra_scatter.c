/* Sunlight that the sunlit air of the Earth's limb scatters into the shadow,
 * E(lambda) = E_sun(lambda) int L/E_0 cos(Theta) dOmega over the limb
 * (environment/umbra_scatter.c). Refracted light ends where the Sun is a degree below the limb, 17
 * s behind the edge in a low orbit; this lasts for some 200 s more. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->umbra_scatter_on = false)

const struct um_effect um_effects_umbra_scatter = {
    UM_EFFECT_ABI,
    .name = "umbra_scatter",
    .summary = "The Earth's air scatters sunlight into the umbra, where it lights the satellite",
    .reference = "Rozenberg 1966, Twilight; sasktran2, University of Saskatchewan",
    .validity =
        "while shadow_refraction is on, and it is 1e-8 of sunlight or more, the Sun down to 13 deg "
        "below the limb; 0.30-2.0 um; "
        "standard air with ozone, aerosols and clouds as environment.shadow_air states, of middle "
        "latitudes where it states none; scattered once (more often: 2 to 8 %); aerosol by an "
        "asymmetry of 0.70, a factor of 2 of its part; comes from where the Sun stands, "
        "though it is an arc of the limb: glints are not as bright; its heat (0.1 W/m2) and its "
        "light between surfaces are left out",
    .separated_by =
        "shadow_refraction, moonlight and background: minutes in the umbra, in which it "
        "falls by half or more each 20 s; the Moon stays",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
