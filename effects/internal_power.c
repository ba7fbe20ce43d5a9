/* Dissipation inside a part: Q is added to the heat balance of its interior node,
 *
 *   C dT/dt = P + Q + sum G (T_j - T) + sigma e* A (T_skin^4 - T^4).
 *
 * A constant offset, independent of sunlight: largest in relation late in eclipse. What is inside
 * dissipates and does not cool: P + Q is 0 or more, with the least of a power history, unless the
 * scenario states less. */
#include <math.h>

#include "effects/interior_impl.h"
#include "effects/list_impl.h"
#include "thermal/network/body.h"

#define ROUNDING 1e-12 /* of the power that is taken away: a sum that is nothing */

/* The least that is dissipated inside [W]. */
static double least(const struct um_thermal_interior_spec *interior)
{
  const struct um_thermal_power_history *history = interior->history;
  double low = history == NULL || history->nrow == 0 ? 0.0 : history->power[0];
  for (size_t i = 0; history != NULL && i < history->nrow; i++) low = fmin(low, history->power[i]);
  return interior->power + low;
}

static enum um_status add_power(struct um_context *context, const struct um_effect_use *use,
                                const char *part, struct um_thermal_part_spec *spec)
{
  struct um_thermal_interior_spec *interior;
  UM_TRY(um_effects_interior_find(context, use, part, spec, "take the power", &interior));
  if (interior == NULL) return UM_OK;
  double low = least(interior), all = low + use->value[0];
  interior->power += use->value[0];
  if (use->value[0] >= 0.0 || all >= 0.0) return UM_OK;
  if (all > ROUNDING * use->value[0]) {
    interior->power -= all;
    return UM_OK;
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'internal_power': power_W %g makes the power inside '%s' %g W; "
                      "accepted: 0 or more in all",
                      use->value[0], use->target, all);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  /* what is inside does not cool; how far a history lets it go down, `least` says */
  double power = n->interior_power + out->null_value;
  um_effect_state(out, "power inside", "W", power,
                  n->has_power_history ? -INFINITY : fmin(0.0, power), INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "power_W",
     .unit = "W",
     .help = "heat released inside, added to what the scenario states; below 0: less than stated",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = -1e5,
     .maximum = 1e5,
     .prior_sigma = INFINITY,
     .stated = stated,
     .prior = "watts on a CubeSat, kilowatts on ENVISAT: no common width"},
};

const struct um_effect um_effects_internal_power = {
    UM_EFFECT_ABI,
    .name = "internal_power",
    .summary = "Electronics or heaters inside a part release heat",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity =
        "a part with an interior node; constant in time, periodic states included; 0 or more "
        "in all",
    .separated_by = "mli_emittance and emittance: temperatures or thermal infrared late in a long "
                    "eclipse, of a radiator beside a side behind MLI; the visible does not change",
    .targets = UM_TARGET_PART | UM_TARGET_INTERIOR,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.part = add_power},
};
