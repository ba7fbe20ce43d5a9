/* Level of the Earth's albedo: clouds, ice, oceans and season make a' = f a. It heats, and it
 * lights by earthshine, in proportion. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static enum um_status scale(struct um_context *context, const struct um_effect_use *use,
                            struct um_environment *environment)
{
  environment->albedo *= use->value[0];
  environment->albedo_factor *= use->value[0];
  if (environment->albedo <= 1.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'albedo_level': factor %g makes the albedo %g; accepted: up to 1",
                      use->value[0], environment->albedo);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_environment *e = n->environment;
  if (e->earth == UM_EARTH_UNIFORM)
    um_effect_state(out, "albedo", "1", e->albedo, 0.0, 1.0);
  else
    um_effect_state(out, "factor of the map's albedo", "1", e->albedo_factor, 0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the scenario's albedo, in heat loads and in earthshine",
     .null_value = 1.0,
     .default_value = 1.3,
     .minimum = 0.0,
     .maximum = 3.0,
     .prior_sigma = 0.5,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.1 to 0.8 at a place, 0.3 in the mean",
     .formerly = "albedo_factor"},
};

const struct um_effect um_effects_albedo_level = {
    UM_EFFECT_ABI,
    .name = "albedo_level",
    .summary = "The Earth below reflects more or less sunlight than its mean",
    .reference = "Anderson, Justus & Batts 2001, NASA/TM-2001-211221",
    .validity = "the scenario's albedo after the factor up to 1, and each place's where "
                "the Earth is not uniform",
    .separated_by =
        "solar_absorptance: temperatures over a whole orbit, or visible light at large phase "
        "angles; it follows the Sun over the ground below and vanishes on the night side",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = scale},
};
