/* Level of sunlight: S' = f S at 1 au, in heat loads, reflected sunlight and earthshine. The
 * distance of the Sun is already in S/d^2. */
#include "effects/list_impl.h"

UM_EFFECT_ON_ENVIRONMENT(scale, environment->solar_irradiance *= use->value[0])

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "solar irradiance", "W/m^2", n->environment->solar_irradiance, 0.0,
                  INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the scenario's solar irradiance at 1 au",
     .null_value = 1.0,
     .default_value = 1.034,
     .minimum = 0.8,
     .maximum = 1.2,
     .prior_sigma = 0.017,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "3.4 % where the distance of the Sun was left out",
     .formerly = "irradiance_factor"},
};

const struct um_effect um_effects_solar_irradiance = {
    UM_EFFECT_ABI,
    .name = "solar_irradiance",
    .summary = "Sunlight is stronger or weaker than stated",
    .reference = "Kopp & Lean 2011, Geophys. Res. Lett. 38:L01706",
    .validity = "one factor for the whole spectrum, constant in time",
    .separated_by = "zero_point, and solar_absorptance of all materials: temperatures in sunlight "
                    "beside visible light of the same factor; the irradiance itself is measured "
                    "from satellites to 0.1 %",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = scale},
};
