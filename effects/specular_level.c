/* Level of the specular lobe: Fresnel's F times a factor. */
#include "effects/list_impl.h"
#include "materials/materials.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->material == NULL || !um_materials_has_lobe(n->material)) return;
  um_effect_state(
      out, "specular reflectance at 0.55 um", "1",
      um_materials_specular_reflectance(n->material, n->adjustment, UM_EFFECT_VISIBLE, 1.0), 0.0,
      1.0);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the specular reflectance",
     .null_value = 1.0,
     .default_value = 1.2,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.2,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "20 % of a reflectance measured at one angle",
     .formerly = "F_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->specular_scale *= use->value[0])

const struct um_effect um_effects_specular_level = {
    UM_EFFECT_ABI,
    .name = "specular_level",
    .summary = "The specular lobe is stronger or weaker",
    .reference = "Cook & Torrance 1982, ACM Trans. Graphics 1:7",
    .validity = "materials with a lobe; reflectance never passes what energy allows; absorptance "
                "and emittance stay",
    .separated_by = "zero_point and roughness: height and area of a glint change together and the "
                    "light between glints stays",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
