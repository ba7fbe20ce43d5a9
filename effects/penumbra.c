/* Penumbra: sunlit fraction of the solar disc behind the limb of the Earth, nu = 1 - A / (pi a^2)
 * for a uniform disc; a limb-darkened one, of brightness 1 - u (1 - mu), fades later and faster. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_SWITCH(switch_off, environment->disc = UM_DISC_POINT)

static bool is_off(const struct um_environment *environment)
{
  return environment->disc == UM_DISC_POINT;
}

static enum um_status switch_on(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  if (is_off(environment)) environment->disc = UM_DISC_LIMB_DARKENED;
  return UM_OK;
}

UM_EFFECT_ON_ENVIRONMENT(darken, environment->limb_darkening *= use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "limb_darkening",
     .unit = "1",
     .help = "of the limb darkening that the environment states; 0: a uniform disc",
     .null_value = 1.0,
     .default_value = 1.0,
     .minimum = 0.0,
     .maximum = 1.0,
     .prior_sigma = INFINITY,
     .prior = "both discs are in use; a diagnosis that switches the penumbra on tries both"},
};

const struct um_effect um_effects_penumbra = {
    UM_EFFECT_ABI,
    .name = "penumbra",
    .summary = "The Sun is a disc: sunlight fades over seconds at the edge of the shadow",
    .reference = "Montenbruck & Gill 2000, section 3.4.2",
    .validity =
        "off: the Sun is a point and the shadow has an edge; off where environment.disc is "
        "point, until it is switched on, which gives a disc limb-darkened or uniform; of no effect "
        "with a cylinder",
    .separated_by = "shadow_radius and time_tag: light sampled every second or faster through an "
                    "edge of the shadow shows whether it fades or is cut off",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = darken},
    .switch_off = switch_off,
    .is_off = is_off,
    .switch_on = switch_on,
};
