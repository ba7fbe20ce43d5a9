/* Heat capacity of what is inside a part: electronics, battery, rods that the walls hand heat to,
 *
 *   (C + dC) dT/dt = P + sum G (T_j - T) + sigma e* A (T_skin^4 - T^4).
 *
 * The walls follow the Sun with a lag and a smaller swing; with G the lag is (C + dC) / G. A steady
 * state does not feel it. With C near 0 the interior hands its power on at once: what is then
 * missing is the whole store. */
#include <math.h>

#include "effects/interior_impl.h"
#include "effects/list_impl.h"
#include "thermal/network/body.h"

static enum um_status add_capacity(struct um_context *context, const struct um_effect_use *use,
                                   const char *part, struct um_thermal_part_spec *spec)
{
  struct um_thermal_interior_spec *interior;
  UM_TRY(um_effects_interior_find(context, use, part, spec, "store heat", &interior));
  if (interior == NULL) return UM_OK;
  interior->capacity += use->value[0];
  if (interior->capacity >= 0.0) return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "effect 'interior_capacity': capacity_J_K %g makes the capacity inside '%s' %g "
      "J/K; accepted: 0 or more in all",
      use->value[0], use->target, interior->capacity);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "heat capacity inside", "J/K", n->interior_capacity + out->null_value, 0.0,
                  INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "capacity_J_K",
     .unit = "J/K",
     .help = "heat capacity inside, added to what the scenario states; below 0: less than stated",
     .null_value = 0.0,
     .default_value = 300.0,
     .minimum = -1e9,
     .maximum = 1e9,
     .prior_sigma = INFINITY,
     .stated = stated,
     .prior = "300 J/K in a CubeSat, 5 MJ/K in ENVISAT: no common width"},
};

const struct um_effect um_effects_interior_capacity = {
    UM_EFFECT_ABI,
    .name = "interior_capacity",
    .summary = "The inside of a part stores more heat than stated, or less",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity = "a part with an interior node, 0 or more in all; nothing to see in a steady state",
    .separated_by = "heat_capacity: what is inside follows the walls late, what is in the walls "
                    "does not; a temperature within the first minutes of an eclipse, or of both",
    .targets = UM_TARGET_PART | UM_TARGET_INTERIOR,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.part = add_capacity},
};
