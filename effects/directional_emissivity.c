/* Directional emissivity: eps(theta) = eps + d eps_h (1 - 21 (1 - cos theta)^5) / 20. Schlick's
 * dielectric 1 - R = (1 - R_0)(1 - (1 - cos)^5), divided by its hemispherical value (1 - R_0)
 * 20/21, is d = 1; emissivities of metals rise to grazing, d < 0. The hemispherical value is kept;
 * what is not emitted is reflected Earth, and what the Earth sends is absorbed alike
 * (absorptance_angle), which moves temperatures of spectral records a little. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "tilt",
     .unit = "1",
     .help = "1: a dielectric, dark at grazing; negative: a metal, bright at grazing",
     .null_value = 0.0,
     .default_value = 1.0,
     .minimum = -2.0,
     .maximum = 1.0,
     .prior_sigma = 0.5,
     .prior = "dielectrics fall and metals rise toward grazing by up to 30 %"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->emissivity_tilt += use->value[0])

const struct um_effect um_effects_directional_emissivity = {
    UM_EFFECT_ABI,
    .name = "directional_emissivity",
    .summary = "Emissivity depends on the angle of view, its hemispherical value being kept",
    .reference = "Schlick 1994, Computer Graphics Forum 13:233",
    .validity =
        "above 2.5 um; added to what the record already has; an emissivity stays within 0 and 1",
    .separated_by =
        "band_emissivity: thermal infrared of one side over a range of angles, best over a turn of "
        "the spin and in eclipse, where it changes at twice the spin rate",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
