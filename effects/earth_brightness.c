/* Brightness temperature of the Earth in the band: the satellite reflects (1 - eps) F B(T_b + d).
 * Clouds are cold, deserts warm; temperatures of the satellite do not feel it. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static enum um_status shift(struct um_context *context, const struct um_effect_use *use,
                            struct um_environment *environment)
{
  environment->brightness_temperature += use->value[0];
  environment->brightness_shift += use->value[0];
  if (environment->brightness_temperature > 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'earth_brightness': shift_K %g makes the "
                      "brightness temperature %g K; accepted: above 0",
                      use->value[0], environment->brightness_temperature);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_environment *e = n->environment;
  if (e->earth == UM_EARTH_UNIFORM)
    um_effect_state(out, "brightness temperature of the Earth", "K", e->brightness_temperature, 0.0,
                    INFINITY);
  else
    um_effect_state(out, "shift of the map's brightness temperature", "K", e->brightness_shift,
                    -INFINITY, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "shift_K",
     .unit = "K",
     .help = "added to the scenario's brightness temperature of the Earth",
     .null_value = 0.0,
     .default_value = -20.0,
     .minimum = -120.0,
     .maximum = 80.0,
     .prior_sigma = 20.0,
     .stated = stated,
     .prior = "220 K over cloud to 290 K over desert",
     .formerly = "brightness_temperature_shift_K"},
};

const struct um_effect um_effects_earth_brightness = {
    UM_EFFECT_ABI,
    .name = "earth_brightness",
    .summary = "The Earth that the satellite reflects is warmer or colder than stated",
    .reference = "Catsamas et al. 2025, arXiv 2511.13030",
    .validity = "one shift for all of the Earth; optics only, while "
                "reflected_earth_ir is on",
    .separated_by = "earth_ir_level and internal_power, which change temperatures: thermal "
                    "infrared of bare metal that faces the Earth changes while its temperature "
                    "stays; earth_reflection_level is the same thing in one band",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = shift},
};
