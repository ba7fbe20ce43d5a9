/* The Earth's air at the edge of the shadow: F = int w T d theta'/d theta d theta over the disc,
 * bent, spread and dimmed by wavelength (environment/shadow_light.c). From a low orbit half
 * of the light is gone some 10 s before the Sun's centre stands on the bare Earth's limb, and red
 * light reaches into the umbra. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->shadow_refraction_on = false)

const struct um_effect um_effects_shadow_refraction = {
    UM_EFFECT_ABI,
    .name = "shadow_refraction",
    .summary = "The Earth's air bends, spreads and dims the sunlight at the edge of the shadow",
    .reference = "Link 1969, Eclipse Phenomena in Astronomy; Mallama 2021, arXiv 2112.08310",
    .validity = "standard air, ozone, aerosols and clouds as environment.shadow_air states; round "
                "shadow and a disc; light and heat, heat by the mean over the solar spectrum",
    .separated_by = "shadow_radius, oblateness and time_tag: two bands, for the blue one is dimmed "
                    "earlier than the red; light below 1e-3 that lasts into the umbra",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
