/* Level of the specular lobe: Fresnel's F times a factor. */
#include "effects/list_impl.h"
#include "materials/materials.h"

static const struct um_effect_parameter parameters[] = {
    {"F_factor", "1", "factor of the specular reflectance", 1.0, 1.2, 0.0, 5.0, 0.2},
};

static enum um_status material(struct um_context *context, const struct um_effect_use *use,
                               const char *name, struct um_materials_adjustment *adjustment)
{
  (void)context;
  if (um_effect_acts_on(use, name)) adjustment->specular_scale *= use->value[0];
  return UM_OK;
}

const struct um_effect um_effects_specular_level = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "specular_level",
    .summary = "The specular lobe is stronger or weaker",
    .reference = "Cook & Torrance 1982, ACM Trans. Graphics 1:7",
    .validity = "materials with a lobe; reflectance never passes what energy allows; absorptance "
                "and emittance stay",
    .targets = UM_TARGET_MATERIAL,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.material = material},
};
