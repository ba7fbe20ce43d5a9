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
extern const struct um_effect um_effects_mli_emittance;
extern const struct um_effect um_effects_heat_capacity;
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

#endif
