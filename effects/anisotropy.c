/* Anisotropy: the lobe is wider across the grain than along it, or narrower, by a factor of the
 * alpha across. Of a lobe that is alike all round it makes one with a grain. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the alpha of the lobe across the grain of the part",
     .null_value = 1.0,
     .default_value = 1.5,
     .minimum = 0.1,
     .maximum = 10.0,
     .prior_sigma = 0.7,
     .logarithmic = true,
     .prior = "tows and brushed metal 1 to 10 times as rough across as along",
     .formerly = "across_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->lobe.log_across += log(use->value[0]))

const struct um_effect um_effects_anisotropy = {
    UM_EFFECT_ABI,
    .name = "anisotropy",
    .summary = "Tows or brushing: glints are drawn out across the grain, or less than was said",
    .reference = "Ward 1992, SIGGRAPH 26:265; Heitz 2014, J. Comput. Graph. Tech. 3(2)",
    .validity = "materials with a lobe of facets; the grain is that of the part; absorptance and "
                "emittance stay; what masking keeps back is that of the mean roughness",
    .separated_by = "roughness and mli_creases: the same glint passed along the grain and across "
                    "it, from two directions of the body or in two passes",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
