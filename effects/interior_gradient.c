/* What is inside a part has not one temperature: a share s of its capacity C and power P stands
 * behind a finite conductance (boards on spacers, a battery on its bracket) and follows the rest,
 * which the walls meet, by a lag l:
 *
 *   (1 - s) C dT/dt = (1 - s) P + sum G (T_j - T) + (s C / l) (T' - T),
 *        s  C dT'/dt =      s  P + (s C / l) (T - T').
 *
 * In l = 0 the inside is isothermal; the slope there is that of stored heat that comes late,
 * -s C d2T/dt2 per second of lag. The share of an inside without lag changes nothing. The
 * temperature of the place is the mean by capacity. */
#include "effects/interior_impl.h"
#include "effects/list_impl.h"
#include "thermal/network/body.h"

static enum um_status split(struct um_context *context, const struct um_effect_use *use,
                            const char *part, struct um_thermal_part_spec *spec)
{
  struct um_thermal_interior_spec *interior;
  UM_TRY(um_effects_interior_find(context, use, part, spec, "store heat", &interior));
  if (interior == NULL || use->value[0] == 0.0) return UM_OK;
  if (!(interior->capacity > 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'interior_gradient': '%s' has no heat capacity that could lag; "
                        "accepted: an interior with capacity_J_K above 0",
                        use->target);
  interior->lag += use->value[0];
  interior->lag_share = use->value[1];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "lag_s",
     .unit = "s",
     .help =
         "by which the share behind follows the rest: its capacity over the conductance between",
     .null_value = 0.0,
     .default_value = 300.0,
     .minimum = 0.0,
     .maximum = 1e6,
     .prior_sigma = 2000.0,
     .prior = "1 to 3 K/W of spacers before 100 J/K of a board; an hour of a battery on brackets"},
    {.name = "share",
     .unit = "1",
     .help = "of capacity and power that stands behind; any value at lag 0",
     .null_value = 0.5,
     .default_value = 0.5,
     .minimum = 0.05,
     .maximum = 0.95,
     .prior_sigma = 0.25,
     .prior = "half of what is inside is structure, half boards and battery"},
};

const struct um_effect um_effects_interior_gradient = {
    UM_EFFECT_ABI,
    .name = "interior_gradient",
    .summary = "What is inside a part is not of one temperature: a share of it follows late",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity = "a part with an interior that stores heat; heaters in it, contacts, walls and "
                "blankets meet the share in front; nothing to see in a steady state",
    .separated_by = "interior_capacity: the walls move on two time scales, a temperature of them "
                    "through several eclipses of different length",
    .targets = UM_TARGET_PART | UM_TARGET_INTERIOR,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.part = split},
};
