/* Zero point: a constant factor of what is measured, throughput and calibration together. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {"factor", "1", "measured by true irradiance", 1.0, 0.9, 0.01, 100.0, 0.5},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  if (um_effect_acts_on(use, o->band)) o->value *= use->value[0];
  return UM_OK;
}

const struct um_effect um_effects_zero_point = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "zero_point",
    .summary = "The calibration of a band is off by a factor",
    .reference = "Bessell 2005, Annu. Rev. Astron. Astrophys. 43:293",
    .validity =
        "constant over all observations; acts on irradiance in the order of the list of effects",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.observation = observation},
};
