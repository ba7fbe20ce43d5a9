/* The Earth in the lobe of a surface: L = int f_r(i, o) L_E(i) cos_i dw over the visible cap, for
 * what the Earth reflects and for what it emits (optics/radiance/earth_lobe.c). Without it light of
 * the Earth leaves every surface as if that were rough: the diffuse part alone in the visible, 1 -
 * eps times the view factor in the infrared. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->earthlight_lobe_on = false)

const struct um_effect um_effects_earthlight_lobe = {
    UM_EFFECT_ABI,
    .name = "earthlight_lobe",
    .summary = "Smooth surfaces mirror the Earth, its sunlit ground and its infrared",
    .reference = "Cook & Torrance 1982; Walter et al. 2007, Eurographics Symposium on Rendering",
    .validity =
        "materials with a lobe, at the wavelengths at which their records state one, grey ones "
        "below 2.5 um; an Earth that varies is looked up where the lobe looks; what the "
        "satellite hides of the Earth is taken alike from the whole lobe",
    .separated_by = "earth_brightness and band_emissivity: infrared of a smooth side that mirrors "
                    "space falls to its own emission, while the same side seen with the Earth in "
                    "its mirror direction keeps all of it",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
