/* Panels that are not flat: those of an array are aligned to a tolerance, bend with heat, and carry
 * cells that lie at angles of their own. */
#include "effects/list_impl.h"
#include "effects/tilts_impl.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effects_tilt_state(n, false, "mean square of the panels' tilt", out);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "tilt_square_deg2",
     .unit = "deg^2",
     .help = "added to the mean square of the patches' tilt per axis; 0.09 is 0.3 deg rms",
     .null_value = 0.0,
     .default_value = 0.09,
     .minimum = -25.0,
     .maximum = 25.0,
     .prior_sigma = 1.0,
     .stated = stated,
     .prior = "rigid arrays 0.1 to 0.5 deg rms, flexible ones more"},
    {.name = "patch_m",
     .unit = "m",
     .help = "edge of a patch, a panel or a cell; 0: the scenario's, or too small to tell apart",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = 0.0,
     .maximum = 10.0,
     .prior_sigma = INFINITY,
     .chosen = true,
     .prior = "cells 0.02 to 0.08 m, panels 0.5 to 3 m"},
};

const struct um_effect um_effects_panel_flatness = {
    UM_EFFECT_ABI,
    .name = "panel_flatness",
    .summary = "Panels and their cells lie at angles a little off their plane",
    .reference = "Small, Butler & Marciniak 2021, Opt. Express 29:35501; docs/physics/creases.md",
    .validity = "groups without MLI and without creases; patches are flat squares of independent "
                "tilts, which share their facet's visibility: no bow of a whole wing, which is "
                "array_angle's; the Earth's light by their mean; absorptance and emittance stay",
    .separated_by = "roughness: glints of single panels, which come again at each turn of the "
                    "satellite, and parts of the same material that stay flat; the mean light "
                    "alone cannot tell",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.flatness = um_effects_tilt},
};
