/* Level of the Earth's outgoing longwave radiation as a heat load: OLR' = f OLR, by latitude,
 * season and cloud. What the satellite reflects of the Earth is earth_brightness. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_ON_ENVIRONMENT(scale, environment->outgoing_longwave *= use->value[0];
                         environment->longwave_factor *= use->value[0])

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_environment *e = n->environment;
  if (e->earth == UM_EARTH_UNIFORM)
    um_effect_state(out, "outgoing longwave radiation", "W/m^2", e->outgoing_longwave, 0.0,
                    INFINITY);
  else
    um_effect_state(out, "factor of the map's outgoing longwave radiation", "1", e->longwave_factor,
                    0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the scenario's outgoing longwave radiation",
     .null_value = 1.0,
     .default_value = 0.9,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.15,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "150 to 300 W/m^2 about 237",
     .formerly = "olr_factor"},
};

const struct um_effect um_effects_earth_ir_level = {
    UM_EFFECT_ABI,
    .name = "earth_ir_level",
    .summary = "The Earth below radiates more or less heat than its mean",
    .reference = "Anderson, Justus & Batts 2001, NASA/TM-2001-211221",
    .validity = "one factor for all of the Earth; heat load only, the brightness temperature "
                "in the band stays",
    .separated_by = "internal_power and mli_emittance: temperatures of a side that faces the Earth "
                    "beside one that faces space, day and night",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = scale},
};
