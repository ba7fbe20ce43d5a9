/* Earth IR as a heat load: q = epsilon OLR F(plate -> Earth). Its optical twin is
 * reflected_earth_ir. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->planet_on = false)

const struct um_effect um_effects_earth_ir = {
    UM_EFFECT_ABI,
    .name = "earth_ir",
    .summary = "Thermal radiation of the Earth heats the satellite",
    .reference = "Anderson, Justus & Batts 2001, NASA/TM-2001-211221",
    .validity = "uniform outgoing longwave radiation of the scenario",
    .separated_by = "internal_power and mli_emittance: temperatures in the umbra of a side that "
                    "faces the Earth beside one that faces space",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
