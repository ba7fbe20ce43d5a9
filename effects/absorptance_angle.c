/* Absorptance by angle of incidence,
 *
 *   alpha(theta) = int S(lambda) (1 - rho(lambda, theta)) d lambda / int S(lambda) d lambda:
 *
 * cover glass and metals reflect more of what comes at grazing angles, and what a surface reflects
 * it does not absorb. The Earth is taken over its cap, of albedo and of its own radiation
 *
 *   int alpha(theta) L cos(theta) dOmega,   int eps(theta, T_E) L cos(theta) dOmega
 *
 * by angular moments of the loads (environment/angular_moments.h), T_E that of its radiation; what
 * other surfaces reflect comes from all sides and is taken with the hemispherical mean. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->absorptance_by_angle = false)

const struct um_effect um_effects_absorptance_angle = {
    UM_EFFECT_ABI,
    .name = "absorptance_angle",
    .summary = "Surfaces absorb less of the light of Sun and Earth that comes at grazing angles",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook, chapter 4; Fresnel",
    .validity = "materials with spectra; grey ones state one absorptance for all angles. Off: that "
                "of normal incidence, of the Earth's infrared the hemispherical one. Electrical "
                "extraction goes with it; what other surfaces and mirrors of the satellite send "
                "on is absorbed as from all sides",
    .separated_by = "solar_absorptance and panel_extraction: temperatures at different angles of "
                    "the Sun on one surface; at normal incidence it does nothing to sunlight",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
