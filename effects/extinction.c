/* Atmospheric extinction: E 10^(-0.4 k X), X the airmass. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {"k_mag", "mag", "extinction at airmass 1", 0.0, 0.2, -2.0, 5.0, 0.3},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  /* no airmass without a station; below the horizon the irradiance is NaN already */
  if (um_effect_acts_on(use, o->band) && !isnan(o->airmass))
    o->value *= pow(10.0, -0.4 * use->value[0] * o->airmass);
  return UM_OK;
}

const struct um_effect um_effects_extinction = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "extinction",
    .summary = "The atmosphere dims the satellite, more toward the horizon",
    .reference = "Kasten & Young 1989, Appl. Opt. 28:4735; Patat et al. 2011, A&A 527:A91",
    .validity = "one coefficient a band, over all its wavelengths; acts on irradiance in the order "
                "of the list of effects; of no effect without a station",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    .parameters = parameters,
    .nparameter = sizeof parameters / sizeof parameters[0],
    .hooks = {.observation = observation},
};
