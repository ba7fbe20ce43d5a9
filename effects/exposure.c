/* Integration smear: observations are means over a longer exposure than was said. A box of length T
 * has the variance T^2/12, so glints lose height in proportion to T^2: the parameter is the square
 * of the unknown exposure, which adds in squares, T^2 = T_0^2 + s. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "square_s2",
     .unit = "s^2",
     .help = "added to the square of the exposure",
     .null_value = 0.0,
     .fallback = 1.0,
     .minimum = 0.0,
     .maximum = 1e4,
     .prior_sigma = 10.0,
     .prior = "exposures of 0.05 to 3 s"},
};

static double exposure(const struct um_effect_use *use, double known)
{
  return use->value[0] == 0.0 ? known : sqrt(known * known + use->value[0]);
}

const struct um_effect um_effects_exposure = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "exposure",
    .summary = "Observations are smeared over a longer exposure",
    .reference = "Kipping 2010, MNRAS 408:1758",
    .validity = "mid-exposure is kept; averaged over the scenario's exposure_samples instants; "
                "exposures must not overlap",
    .separated_by = "roughness: glints of the same satellite in two exposure times; smear loses "
                    "height in the longer one, a rough surface in both",
    .targets = UM_TARGET_GLOBAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.exposure = exposure},
};
