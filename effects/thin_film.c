/* Films and covers on a surface are thicker than the record says, or are not there: thickness times
 * a factor. What interferes changes its colour, what absorbs changes both absorptance and
 * emittance, all from the same optical constants. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the thickness of all layers on the substrate; 0: bare",
     .null_value = 1.0,
     .default_value = 1.2,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.3,
     .prior = "sheet is sold in steps of a factor of 2, coatings vary by 5 to 30 % over a surface",
     .formerly = "thickness_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->thickness_scale *= use->value[0])

const struct um_effect um_effects_thin_film = {
    UM_EFFECT_ABI,
    .name = "thin_film",
    .summary = "Films and covers on a surface are thicker or thinner, or not there: absorptance, "
               "emittance and colour follow together",
    .reference = "Born & Wolf 1999, 1.6; Byrnes 2016, arXiv 1603.02720",
    .validity = "records of optical constants with sheet or layers, others stay; the same all the "
                "time; mass and heat capacity stay",
    .separated_by = "emittance, band_emissivity and solar_absorptance: two bands in which the film "
                    "absorbs unlike, or a temperature beside the light; it moves all of them by "
                    "one number",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
