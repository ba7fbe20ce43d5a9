/* Level of the diffuse reflectance, rho_d times a factor, in reflected light alone: the heat that
 * is absorbed stays. */
#include "effects/list_impl.h"
#include "materials/materials.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->material == NULL) return;
  um_effect_state(out, "diffuse reflectance at 0.55 um", "1",
                  um_materials_diffuse_reflectance(n->material, n->adjustment, UM_EFFECT_VISIBLE),
                  0.0, 1.0);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the diffuse reflectance",
     .null_value = 1.0,
     .default_value = 0.8,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.3,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "diffuse reflectances of 0 to 0.3 are quoted for one surface",
     .formerly = "diffuse_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->diffuse_scale *= use->value[0])

const struct um_effect um_effects_diffuse_level = {
    UM_EFFECT_ABI,
    .name = "diffuse_level",
    .summary = "The diffuse part of the reflected sunlight is stronger or weaker",
    .reference = "Nicodemus et al. 1977, NBS Monograph 160",
    .validity = "below 2.5 um; reflectance never passes what energy allows; absorptance stays",
    .separated_by = "zero_point and area: the light between glints changes while glints and the "
                    "thermal infrared stay",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
