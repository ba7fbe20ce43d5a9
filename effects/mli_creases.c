/* Creases of MLI: a blanket hangs in flat patches that are tilted a little. */
#include "effects/list_impl.h"
#include "effects/tilts_impl.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effects_tilt_state(n, true, "mean square of the creases' tilt", out);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "tilt_square_deg2",
     .unit = "deg^2",
     .help = "added to the mean square of the patches' tilt per axis; 9 is 3 deg rms",
     .null_value = 0.0,
     .default_value = 9.0,
     .minimum = -900.0,
     .maximum = 900.0,
     .prior_sigma = 25.0,
     .stated = stated,
     .prior = "tilts of 1 to 10 deg rms"},
    {.name = "patch_m",
     .unit = "m",
     .help = "edge of a patch; 0: the scenario's, or too small to tell apart",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = 0.0,
     .maximum = 10.0,
     .prior_sigma = INFINITY,
     .chosen = true,
     .prior = "0.01 to 0.3 m"},
};

const struct um_effect um_effects_mli_creases = {
    UM_EFFECT_ABI,
    .name = "mli_creases",
    .summary = "Blankets hang in creases: glints of their flat patches come over many directions",
    .reference = "Walter et al. 2007, EGSR; Yan et al. 2014, ACM Trans. Graph. 33:116",
    .validity = "groups with MLI, or with creases that the scenario states; patches are flat "
                "squares of independent tilts, which share their facet's visibility; absorptance "
                "and emittance stay; what mirrors heat does so no more once its lobe is wider "
                "than specular_exchange takes",
    .separated_by = "roughness: glints of single patches, which come again at each turn of the "
                    "satellite; the mean light alone cannot tell",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.creases = um_effects_tilt},
};
