/* Level of the earthshine: sunlight reflected by the Earth, as light only. Its thermal twin is the
 * albedo load, which stays. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_environment *e = n->environment;
  if (e->earth == UM_EARTH_UNIFORM)
    um_effect_state(out, "albedo as light", "1", e->albedo * e->earthshine_factor, 0.0, INFINITY);
  else
    um_effect_state(out, "factor of the map's albedo as light", "1",
                    e->albedo_factor * e->earthshine_factor, 0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "factor of the earthshine",
     .null_value = 1.0,
     .default_value = 1.3,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.5,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "clouds, ice and oceans: 0.1 to 0.8 about 0.3"},
};

UM_EFFECT_ON_ENVIRONMENT(environment, environment->earthshine_factor *= use->value[0])

const struct um_effect um_effects_earthshine_level = {
    UM_EFFECT_ABI,
    .name = "earthshine_level",
    .summary = "The sunlit Earth is brighter or darker than modelled",
    .reference = "Fankhauser et al. 2023, arXiv 2305.11123",
    .validity = "optics only, heat loads stay; of no effect where earthshine is off",
    .separated_by = "background and diffuse_level: visible light of a satellite in shadow over the "
                    "lit Earth; it follows the height of the Sun over the ground below",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = environment},
};
