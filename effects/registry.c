/* The one list. A new effect is a new file and a new line here. */
#include <string.h>

#include "effects/effects.h"
#include "effects/list_impl.h"

static const struct um_effect *const list[] = {
    &um_effects_albedo,
    &um_effects_earth_ir,
    &um_effects_earthshine,
    &um_effects_reflected_earth_ir,
    &um_effects_penumbra,
    &um_effects_oblateness,
    &um_effects_internal_power,
    &um_effects_heater,
    &um_effects_stored_heat,
    &um_effects_mli_emittance,
    &um_effects_heat_capacity,
    &um_effects_interior_capacity,
    &um_effects_solar_absorptance,
    &um_effects_emittance,
    &um_effects_panel_extraction,
    &um_effects_through_conductance,
    &um_effects_contact_conductance,
    &um_effects_albedo_level,
    &um_effects_earth_ir_level,
    &um_effects_earth_brightness,
    &um_effects_solar_irradiance,
    &um_effects_shadow_radius,
    &um_effects_band_emissivity,
    &um_effects_directional_emissivity,
    &um_effects_roughness,
    &um_effects_specular_level,
    &um_effects_diffuse_level,
    &um_effects_area,
    &um_effects_array_angle,
    &um_effects_attitude_offset,
    &um_effects_spin_period,
    &um_effects_time_tag,
    &um_effects_along_track,
    &um_effects_exposure,
    &um_effects_earthshine_level,
    &um_effects_earth_reflection_level,
    &um_effects_extinction,
    &um_effects_zero_point,
    &um_effects_background,
};

size_t um_effects_count(void) { return sizeof list / sizeof list[0]; }

const struct um_effect *um_effects_at(size_t index) { return list[index]; }

const struct um_effect *um_effects_find(const char *name)
{
  for (size_t i = 0; i < um_effects_count(); i++)
    if (strcmp(list[i]->name, name) == 0) return list[i];
  return NULL;
}

void um_effects_names(char *out, size_t size) { um_effects_registry_names(NULL, out, size); }
