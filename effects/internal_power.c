/* Dissipation inside a part: Q is added to the heat balance of its interior node,
 *
 *   C dT/dt = P + Q + sum G (T_j - T) + sigma e* A (T_skin^4 - T^4).
 *
 * A constant offset, independent of sunlight: largest in relation late in eclipse. */
#include <math.h>

#include "effects/list_impl.h"
#include "thermal/body.h"

static enum um_status add_power(struct um_context *context, const struct um_effect_use *use,
                                const char *part, struct um_thermal_part_spec *spec)
{
  if (!um_effect_acts_on(use, part)) return UM_OK;
  if (!spec->has_interior)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "effect 'internal_power': the part '%s' has no interior that could take the "
        "power; accepted: a part with interior",
        part);
  spec->interior_power += use->value[0];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "power_W",
     .unit = "W",
     .help = "heat released inside, added to what the scenario states",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = -1e5,
     .maximum = 1e5,
     .prior_sigma = INFINITY,
     .stated = UM_STATED_INTERIOR_POWER,
     .prior = "watts on a CubeSat, kilowatts on ENVISAT: no common width"},
};

const struct um_effect um_effects_internal_power = {
    UM_EFFECT_ABI,
    .name = "internal_power",
    .summary = "Electronics or heaters inside a part release heat",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity = "a part with an interior node; constant in time, periodic states included",
    .separated_by = "mli_emittance and emittance: temperatures or thermal infrared late in a long "
                    "eclipse, of a radiator beside a side behind MLI; the visible does not change",
    .targets = UM_TARGET_PART,
    .parameters = parameters,
    .nparameter = 1,
    .hooks = {.part = add_power},
};
