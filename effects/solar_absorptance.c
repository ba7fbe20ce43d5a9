/* Solar absorptance of a material: what ultraviolet light, atomic oxygen and contamination do,
 *
 *   alpha' = alpha + d,  rho_d' = rho_d - d below 2.5 um.
 *
 * It warms in sunlight and darkens in the visible at once; the end of an eclipse does not feel it.
 * Its confounder, panel_extraction, leaves the visible alone. */
#include "effects/list_impl.h"
#include "materials/materials.h"

UM_EFFECT_ON_MATERIAL(shift, adjustment->absorptance_shift += use->value[0])

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->material == NULL) return;
  um_effect_state(out, "solar absorptance", "1",
                  um_materials_solar_absorptance(n->material, n->adjustment), 0.0, 1.0);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "shift",
     .unit = "1",
     .help = "added to the solar absorptance, taken from the diffuse reflectance below 2.5 um",
     .null_value = 0.0,
     .default_value = 0.1,
     .minimum = -0.5,
     .maximum = 0.5,
     .prior_sigma = 0.15,
     .stated = stated,
     .prior = "ageing gives 0 to 0.3",
     .formerly = "absorptance_shift"},
};

const struct um_effect um_effects_solar_absorptance = {
    UM_EFFECT_ABI,
    .name = "solar_absorptance",
    .summary = "A surface aged: it absorbs more sunlight and is darker in the visible",
    .reference = "Silverman 1995, NASA CR-4661",
    .validity = "grey in wavelength below 2.5 um; absorptance stays within 0 to 1, and what the "
                "diffuse reflectance cannot give is taken from the specular",
    .separated_by = "panel_extraction and emittance: visible light beside a temperature; ageing "
                    "darkens what it warms, and the end of an eclipse does not know of it",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = shift},
};
