/* Earthshine: L_o = rho_d(lambda) E_albedo(lambda) / pi. It lights the satellite in its own umbra
 * as long as it sees a sunlit Earth. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->earthshine_on = false)

const struct um_effect um_effects_earthshine = {
    UM_EFFECT_ABI,
    .name = "earthshine",
    .summary = "Sunlight reflected by the Earth and again by the satellite reaches the observer",
    .reference = "Fankhauser et al. 2023, arXiv 2305.11123",
    .validity = "uniform Lambert Earth, grey in wavelength",
    .separated_by = "background and zero_point: visible light while the satellite is in shadow or "
                    "at large phase angles follows the height of the Sun over the ground below, "
                    "and fades when that is in the dark",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
