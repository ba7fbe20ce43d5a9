/* Integration smear: observations are means over a longer exposure than was said, or a shorter one.
 * A box of length T has the variance T^2/12, so glints lose height in proportion to T^2: the
 * parameter is the square of the unknown exposure, which adds in squares, T^2 = T_0^2 + s, never
 * below 0. */
#include "effects/list_impl.h"

/* The longest exposure leads: a shorter one has no less than none. */
static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  double square = n->longest_exposure * n->longest_exposure + out->null_value;
  um_effect_state(out, "square of the longest exposure", "s^2", square, 0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "square_s2",
     .unit = "s^2",
     .help = "added to the square of the exposure; below 0: shorter than said",
     .null_value = 0.0,
     .default_value = 1.0,
     .minimum = -1e4,
     .maximum = 1e4,
     .prior_sigma = 10.0,
     .stated = stated,
     .prior = "exposures of 0.05 to 3 s"},
};

static double exposure(const struct um_effect_use *use, double known)
{
  return use->value[0] == 0.0 ? known : sqrt(fmax(0.0, known * known + use->value[0]));
}

const struct um_effect um_effects_exposure = {
    UM_EFFECT_ABI,
    .name = "exposure",
    .summary = "Observations are smeared over a longer exposure than was said, or a shorter one",
    .reference = "Kipping 2010, MNRAS 408:1758",
    .validity = "mid-exposure is kept; averaged over the scenario's exposure_samples instants; "
                "exposures must not overlap",
    .separated_by = "roughness: glints of the same satellite in two exposure times; smear loses "
                    "height in the longer one, a rough surface in both",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.exposure = exposure},
};
