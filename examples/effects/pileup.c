/* Pulses that pile up in a photon counter: while one is processed the next is lost, so that of E
 *
 *   E' = E (1 + q E)
 *
 * is reported, q = -(dead time) (pulses per second and irradiance); above 0 where pulses are counted
 * twice. q has a slope at 0, so the diagnosis can test it. */
#include "effects/effect.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "q_m2_W",
     .unit = "m^2/W",
     .help = "relative change of what is reported, per irradiance",
     .null_value = 0.0,
     .default_value = -1e8,
     .minimum = -1e15,
     .maximum = 1e15,
     .prior_sigma = INFINITY,
     .prior = "1 to 5 % near saturation; where that lies depends on the instrument"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  double q = use->value[0];
  if (!um_effect_acts_on(use, o->band)) return UM_OK;
  if (q * o->value <= -0.5) /* beyond it more light would be reported as less */
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'pileup': q_m2_W %g at %g W/m^2 in '%s' gives a change of "
                        "%g; accepted: above -0.5",
                        q, o->value, o->band, q * o->value);
  o->value *= 1.0 + q * o->value;
  return UM_OK;
}

const struct um_effect um_effect = {
    UM_EFFECT_ABI,
    .name = "pileup",
    .summary = "Pulses pile up in a photon counter: its bright end is compressed",
    .reference = "Howell 2006, Handbook of CCD Astronomy, section 3.8",
    .validity = "while the change is small; the same response over all observations",
    .separated_by = "roughness and exposure, which flatten glints too: two exposure times of the "
                    "same satellite; the response follows the counts, whatever is glinting",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.observation = observation},
};
