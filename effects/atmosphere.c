/* The air above the station: E = E_0 t(lambda) before filter and detector, t of
 * environment/clear_sky.c along the path of each instant. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->sky.on = false)

const struct um_effect um_effects_atmosphere = {
    UM_EFFECT_ABI,
    .name = "atmosphere",
    .summary = "Clear air takes of the light at every wavelength, before filter and detector",
    .reference = "Bodhaine et al. 1999, J. Atmos. Oceanic Technol. 16:1854; Kneizys et al. 1988, "
                 "AFGL-TR-88-0177",
    .validity =
        "where observer.air states the air; no clouds; acts on irradiance and counts, not on "
        "magnitudes and radiant intensities, which are those without an atmosphere; not "
        "beside extinction of the same band, which stands for it",
    .separated_by = "zero_point and extinction: a pass over a range of airmasses, in two bands of "
                    "different colour",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
