/* Thermal emittance of a material, total and spectral above 2.5 um: eps' = f eps. A sunlit plate
 * stands at T ~ eps^(-1/4), a cooling one falls at a rate ~ eps. */
#include "base/core/constants.h"
#include "effects/list_impl.h"
#include "materials/materials.h"

UM_EFFECT_ON_MATERIAL(scale, adjustment->emittance_scale *= use->value[0])

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->material == NULL) return;
  um_effect_state(out, "emittance", "1",
                  um_materials_emittance(n->material, n->adjustment, UM_REFERENCE_TEMPERATURE), 0.0,
                  1.0);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the total emittance and of the spectral emissivity above 2.5 um",
     .null_value = 1.0,
     .default_value = 0.9,
     .minimum = 0.1,
     .maximum = 10.0,
     .prior_sigma = 0.12,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.1 to 0.2 of an emittance of 0.8",
     .formerly = "emittance_factor"},
};

const struct um_effect um_effects_emittance = {
    UM_EFFECT_ABI,
    .name = "emittance",
    .summary = "A surface emits and absorbs thermal radiation better or worse than its record",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 4",
    .validity = "one factor for all wavelengths above 2.5 um; the emittance stays within 0 to 1",
    .separated_by =
        "heat_capacity, solar_absorptance and internal_power: a temperature followed from sunlight "
        "to the end of an eclipse, or two thermal-infrared bands, whose ratio is a temperature",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = scale},
};
