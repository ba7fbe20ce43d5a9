/* Background that was not, or too much, subtracted: a constant irradiance. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {"irradiance_W_m2", "W/m^2", "added to the irradiance", 0.0, 1e-12, -1e-3, 1e-3, INFINITY},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  if (um_effect_acts_on(use, o->band)) o->value += use->value[0];
  return UM_OK;
}

const struct um_effect um_effects_background = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "background",
    .summary = "A constant light is left in what is measured",
    .reference = "Howell 2006, Handbook of CCD Astronomy, chapter 5",
    .validity =
        "constant over all observations; acts on irradiance in the order of the list of effects",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.observation = observation},
};
