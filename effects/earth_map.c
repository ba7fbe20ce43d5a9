/* The Earth as it is from place to place: albedo and infrared by latitude and season (Knocke), or
 * by the monthly grids of a file. Heat and light have it from one description
 * (environment/ground.h). Tropics emit a third more than poles; ice and cloud reflect three times
 * what the ocean does. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_SWITCH(switch_off, environment->earth = UM_EARTH_UNIFORM)

static bool is_off(const struct um_environment *environment)
{
  return environment->earth == UM_EARTH_UNIFORM;
}

static enum um_status switch_on(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  if (!is_off(environment)) return UM_OK;
  environment->earth = environment->map != NULL ? UM_EARTH_MAP : UM_EARTH_KNOCKE;
  return UM_OK;
}

const struct um_effect um_effects_earth_map = {
    UM_EFFECT_ABI,
    .name = "earth_map",
    .summary = "The Earth reflects and emits differently from place to place and month to month",
    .reference = "Knocke, Ries & Tapley 1988, AIAA 88-4292",
    .validity =
        "off while environment.earth.model is uniform, which it is unless stated, until it is "
        "switched on: then the grids of environment.earth.file, or Knocke's zones; monthly "
        "means, no weather; sunlight goes by earth_anisotropy",
    .separated_by = "albedo_level, earth_ir_level and earth_brightness, which are one for all "
                    "latitudes: temperatures or light of a side that faces the Earth, from the "
                    "tropics to the poles",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
    .is_off = is_off,
    .switch_on = switch_on,
};
