/* Level of the diffuse reflectance, rho_d times a factor, in reflected light alone: the heat that
 * is absorbed stays. */
#include "effects/list_impl.h"
#include "materials/materials.h"

static const struct um_effect_parameter parameters[] = {
    {"diffuse_factor", "1", "factor of the diffuse reflectance", 1.0, 0.8, 0.0, 5.0, 0.3},
};

static enum um_status material(struct um_context *context, const struct um_effect_use *use,
                               const char *name, struct um_materials_adjustment *adjustment)
{
  (void)context;
  if (um_effect_acts_on(use, name)) adjustment->diffuse_scale *= use->value[0];
  return UM_OK;
}

const struct um_effect um_effects_diffuse_level = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "diffuse_level",
    .summary = "The diffuse part of the reflected sunlight is stronger or weaker",
    .reference = "Nicodemus et al. 1977, NBS Monograph 160",
    .validity = "below 2.5 um; reflectance never passes what energy allows; absorptance stays",
    .targets = UM_TARGET_MATERIAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.material = material},
};
