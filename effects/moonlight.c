/* Moonlight: E(lambda) = A(g, lambda) (R/d)^2 (1 au/D)^2 E_sun(lambda) on the satellite
 * (environment/moonlight.c), reflected once, through lobes and diffuse parts. Deep in the umbra of
 * a low orbit nothing else lights a satellite in VIS. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->moonlight_on = false)

const struct um_effect um_effects_moonlight = {
    UM_EFFECT_ABI,
    .name = "moonlight",
    .summary = "Sunlight reflected by the Moon and again by the satellite reaches the observer",
    .reference = "Kieffer & Stone 2005, Astron. J. 129:2887; Krisciunas & Schaefer 1991, PASP "
                 "103:1033 beyond 97 deg of phase",
    .validity =
        "added up where it is more than 1e-4 of the sunlight that arrives: in the umbra and "
        "at its edge, while the Moon is up; the full Moon gives 1/400000 of the Sun; no "
        "libration (7 %); its heat, its light on the Earth and between surfaces are left "
        "out",
    .separated_by =
        "background and shadow_refraction: light in the umbra that follows attitude and "
        "range, and the phase of the Moon from pass to pass; it ends where the Moon "
        "sets",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
