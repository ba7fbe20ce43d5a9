/* Emissivity in the observed infrared band that differs from the total: eps_band = f eps. Silica
 * has its reststrahlen at 9 um and Kapton its absorption bands in 8-12 um, so that a total
 * emittance says little about the band. Temperatures stay. */
#include "effects/list_impl.h"
#include "materials/materials.h"

#define SAMPLES 16 /* wavelengths of a band */

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  double step = (n->infrared_to - n->infrared_from) / SAMPLES, sum = 0.0;
  if (n->material == NULL || isnan(n->infrared_from)) return;
  for (int i = 0; i < SAMPLES; i++)
    sum += 1.0 - um_materials_hemispherical_reflectance(n->material, n->adjustment,
                                                        n->infrared_from + (i + 0.5) * step);
  um_effect_state(out, "emissivity in the infrared band", "1", sum / SAMPLES, 0.0, 1.0);
  out->is_clamped = true;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the emissivity above 2.5 um",
     .null_value = 1.0,
     .default_value = 0.9,
     .minimum = 0.1,
     .maximum = 3.0,
     .prior_sigma = 0.15,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.75 to 1.1 of the total emittance",
     .formerly = "emissivity_factor"},
};

UM_EFFECT_ON_MATERIAL(material, adjustment->band_emissivity_scale *= use->value[0])

const struct um_effect um_effects_band_emissivity = {
    UM_EFFECT_ABI,
    .name = "band_emissivity",
    .summary =
        "The infrared emissivity that is seen differs from the total that sets the temperature",
    .reference = "Kitamura, Pilon & Jonasz 2007, Appl. Opt. 46:8118",
    .validity =
        "above 2.5 um, one factor for all wavelengths; an emissivity ends at 1; temperatures stay",
    .separated_by =
        "emittance, zero_point and area: a temperature of that side measured beside the thermal "
        "infrared stays when only the band differs; a second band tells it from area",
    .targets = UM_TARGET_MATERIAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.material = material},
};
