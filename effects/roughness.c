/* Roughness: the width of the glint, alpha of the lobe times a factor. Peak times
 * width^2 is kept, which separates it from specular_level. */
#include "effects/list_impl.h"
#include "materials/materials.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->material == NULL || !um_materials_has_lobe(n->material)) return;
  um_effect_state(out, "alpha of the lobe", "1", um_materials_roughness(n->material, n->adjustment),
                  0.0, INFINITY);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the alpha of the lobe",
     .null_value = 1.0,
     .default_value = 1.3,
     .minimum = 0.1,
     .maximum = 5.0,
     .prior_sigma = 0.4,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "formulas from a measured roughness differ by factors of 0.5 to 1.8",
     .formerly = "alpha_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->roughness_scale *= use->value[0])

const struct um_effect um_effects_roughness = {
    UM_EFFECT_ABI,
    .name = "roughness",
    .summary = "The surface is rougher or smoother: glints are wider and fainter, or narrower and "
               "brighter",
    .reference = "Beckmann & Spizzichino 1963; Walter et al. 2007, EGSR",
    .validity = "materials with a lobe; absorptance and emittance stay",
    .separated_by = "specular_level and exposure: the profile of a glint in exposures shorter than "
                    "a tenth of it; roughness keeps its area and trades height for width",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
