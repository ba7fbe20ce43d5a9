/* Heat stored inside from before: the run begins with the interior dT above (or below) the state
 * that the scenario begins with,
 *
 *   T_inside(start) = T_periodic + dT,   C dT/dt = P + sum G (T_j - T) + ...
 *
 * and what that adds dies away with the time constant of the interior, C / G: within a pass it
 * looks like power inside, over days it drifts, which power does not. */
#include "effects/interior_impl.h"
#include "effects/list_impl.h"
#include "thermal/network/body.h"

static enum um_status shift(struct um_context *context, const struct um_effect_use *use,
                            const char *part, struct um_thermal_part_spec *spec)
{
  struct um_thermal_interior_spec *interior;
  UM_TRY(um_effects_interior_find(context, use, part, spec, "store heat", &interior));
  if (interior != NULL) interior->offset += use->value[0];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "shift_K",
     .unit = "K",
     .help = "by which the inside is warmer when the run begins, orbits_before ahead of the first "
             "observation",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = -200.0,
     .maximum = 500.0,
     .prior_sigma = 50.0,
     .prior = "50 K either way where loads or attitude changed lately",
     .formerly = "delta_K"},
};

const struct um_effect um_effects_stored_heat = {
    UM_EFFECT_ABI,
    .name = "stored_heat",
    .summary = "The inside of a part still holds heat, or cold, from before",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity = "a part with an interior that stores heat; added to the state the run begins with, "
                "periodic or isothermal",
    .separated_by = "internal_power: repeat passes several time constants of the inside apart; "
                    "stored heat drifts away, power does not",
    .targets = UM_TARGET_PART | UM_TARGET_INTERIOR,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.part = shift},
};
