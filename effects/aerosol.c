/* Aerosol above the station: depth' = depth + d at 0.55 um, d (lambda / 0.55 um)^-angstrom
 * elsewhere. */
#include "effects/list_impl.h"

UM_EFFECT_ON_SKY(add, sky->aerosol += use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "depth",
     .unit = "1",
     .help = "optical depth in the zenith at 0.55 um, beside the scenario's",
     .null_value = 0.0,
     .default_value = 0.1,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.15,
     .prior = "AERONET, clear days of central Europe: 0.05 to 0.3"},
};

const struct um_effect um_effects_aerosol = {
    UM_EFFECT_ABI,
    .name = "aerosol",
    .summary = "Haze above the station takes of the light, the more the shorter its wavelength",
    .reference =
        "Angstrom 1929, Geogr. Ann. 11:156; Holben et al. 2001, J. Geophys. Res. 106:12067",
    .validity = "where observer.air states a profile, not a file; one exponent, constant over the "
                "observations",
    .separated_by = "extinction and zero_point: two bands of different colour over a range of "
                    "airmasses; standard stars",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.sky = add},
};
