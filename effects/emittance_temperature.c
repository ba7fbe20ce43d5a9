/* Emittance at the wall's own temperature,
 *
 *   eps(T) = int eps(lambda) B(lambda, T) d lambda / (sigma T^4 / pi):
 *
 * a cold surface emits at longer wavelengths, where films are more transparent and metals reflect
 * more. The Earth's radiation is absorbed with the emittance at the Earth's own temperature,
 * (OLR / sigma)^(1/4), in place of the surface's. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->emittance_by_temperature = false)

const struct um_effect um_effects_emittance_temperature = {
    UM_EFFECT_ABI,
    .name = "emittance_temperature",
    .summary = "Surfaces emit with the emittance that they have at their own temperature",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook, chapter 4; Planck, Kirchhoff",
    .validity = "materials with spectra, 40 to 1280 K; grey ones state one emittance. Off: that of "
                "300 K, for emission and for the Earth's radiation",
    .separated_by = "emittance, mli_emittance and internal_power: one surface warm and cold; at "
                    "300 K it does nothing",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
