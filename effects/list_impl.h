/* Descriptors of the built-in effects, private to the registry. */
#ifndef UMBRA_EFFECTS_LIST_IMPL_H
#define UMBRA_EFFECTS_LIST_IMPL_H

#include "core/effect.h"

extern const struct um_effect um_effects_albedo;
extern const struct um_effect um_effects_earth_ir;
extern const struct um_effect um_effects_earthshine;
extern const struct um_effect um_effects_reflected_earth_ir;
extern const struct um_effect um_effects_penumbra;
extern const struct um_effect um_effects_oblateness;
extern const struct um_effect um_effects_internal_power;
extern const struct um_effect um_effects_heater;
extern const struct um_effect um_effects_stored_heat;
extern const struct um_effect um_effects_mli_emittance;
extern const struct um_effect um_effects_heat_capacity;
extern const struct um_effect um_effects_interior_capacity;
extern const struct um_effect um_effects_solar_absorptance;
extern const struct um_effect um_effects_emittance;
extern const struct um_effect um_effects_panel_extraction;
extern const struct um_effect um_effects_through_conductance;
extern const struct um_effect um_effects_contact_conductance;
extern const struct um_effect um_effects_albedo_level;
extern const struct um_effect um_effects_earth_ir_level;
extern const struct um_effect um_effects_earth_brightness;
extern const struct um_effect um_effects_solar_irradiance;
extern const struct um_effect um_effects_shadow_radius;
extern const struct um_effect um_effects_band_emissivity;
extern const struct um_effect um_effects_directional_emissivity;
extern const struct um_effect um_effects_roughness;
extern const struct um_effect um_effects_specular_level;
extern const struct um_effect um_effects_diffuse_level;
extern const struct um_effect um_effects_area;
extern const struct um_effect um_effects_array_angle;
extern const struct um_effect um_effects_attitude_offset;
extern const struct um_effect um_effects_spin_period;
extern const struct um_effect um_effects_time_tag;
extern const struct um_effect um_effects_along_track;
extern const struct um_effect um_effects_exposure;
extern const struct um_effect um_effects_earthshine_level;
extern const struct um_effect um_effects_earth_reflection_level;
extern const struct um_effect um_effects_extinction;
extern const struct um_effect um_effects_zero_point;
extern const struct um_effect um_effects_background;

#endif
