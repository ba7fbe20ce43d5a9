/* A heater with a thermostat: on below T_on, off above T_on + B,
 *
 *   C dT/dt = ... + P s(t),   s = 1 from T = T_on until T = T_on + B, else 0.
 *
 * It shows where the place would grow colder than T_on, mostly in eclipse: a temperature that stops
 * falling, then a saw-tooth whose period, for a gap D = T_on - T_0 to the temperature without the
 * heater and conductance G to it, is about C B P / (G D (P - G D)). A heater too weak is simply on.
 * The slope with P at 0 is there only where the place passes T_on; where it does is to be scanned.
 */
#include <math.h>

#include "effects/list_impl.h"
#include "thermal/network/body.h"

/* What follows the part's name: "" the part, "group", "interior"; NULL: another part. */
static const char *place_of(const struct um_effect_use *use, const char *part)
{
  size_t n = strlen(part);
  if (use->target == NULL || strncmp(use->target, part, n) != 0) return NULL;
  if (use->target[n] == '\0') return use->target + n;
  return use->target[n] == '.' ? use->target + n + 1 : NULL;
}

static enum um_status add_heater(struct um_context *context, const struct um_effect_use *use,
                                 const char *part, struct um_thermal_part_spec *spec)
{
  const char *place = place_of(use, part);
  if (place == NULL || !(use->value[0] > 0.0)) return UM_OK;
  if (spec->nheater >= UM_THERMAL_HEATERS_MAX)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'heater': more than %d heaters on the part '%s'",
                        UM_THERMAL_HEATERS_MAX, part);
  spec->heater[spec->nheater++] = (struct um_thermal_heater){
      .place = place,
      .power = use->value[0],
      .on = use->value[1],
      .off = use->value[1] + use->value[2],
      .phase = use->value[3],
  };
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "power_W",
     .unit = "W",
     .help = "while it is on",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = 0.0,
     .maximum = 1e5,
     .prior_sigma = INFINITY,
     .prior = "a watt on a CubeSat, hundreds on a large satellite: no common width"},
    {.name = "on_K",
     .unit = "K",
     .help = "temperature below which it is switched on; any value at power 0, to be scanned",
     .null_value = 273.15,
     .default_value = 273.15,
     .minimum = 20.0,
     .maximum = 600.0,
     .prior_sigma = 40.0,
     .is_temperature = true,
     .prior = "batteries and tanks 270 to 285 K, structure and mechanisms down to 200 K"},
    {.name = "band_K",
     .unit = "K",
     .help = "it is switched off this much above on_K; any value at power 0",
     .null_value = 2.0,
     .default_value = 2.0,
     .minimum = 0.01,
     .maximum = 50.0,
     .prior_sigma = 1.0,
     .logarithmic = true,
     .prior = "mechanical thermostats 3 to 8 K, electronic ones 0.5 to 2 K"},
    {.name = "phase",
     .unit = "1",
     .help = "where in its cycle the run begins: 0 to 0.5 on, from on_K upward, 0.5 to 1 off, down "
             "again; 0: not stated, on below the middle of the band",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = 0.0,
     .maximum = 1.0,
     .prior_sigma = INFINITY,
     .chosen = true,
     .is_phase = true,
     .prior = "any: nobody knows when it last switched"},
};

const struct um_effect um_effects_heater = {
    UM_EFFECT_ABI,
    .name = "heater",
    .summary = "A thermostat heater keeps a wall or the inside of a part from growing colder",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 7",
    .validity = "walls and interiors that store heat; a side of two layers is the layer of that "
                "name; sensed where it heats; in the orbit that repeats its mean power acts; a "
                "phase needs a place that is within the band, or less than its width above, where "
                "the run begins",
    .separated_by = "heat_capacity and internal_power: the temperature stops falling at one value "
                    "whatever the heat load, and the light does not change while it is warmer; a "
                    "saw-tooth of minutes where sampling is dense",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE | UM_TARGET_INTERIOR,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.part = add_heater},
};
