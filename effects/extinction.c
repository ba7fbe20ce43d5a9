/* Atmospheric extinction: E 10^(-0.4 k X), X the airmass. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "k_mag",
     .unit = "mag",
     .help = "extinction at airmass 1",
     .null_value = 0.0,
     .default_value = 0.2,
     .minimum = -2.0,
     .maximum = 5.0,
     .prior_sigma = 0.3,
     .prior = "0.12 to 0.35 mag in the visible, 0.1 to 0.4 mag at 10 um"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  /* no airmass without a station; below the horizon the irradiance is NaN already */
  if (!o->exo_atmospheric && um_effect_acts_on(use, o->band) && !isnan(o->airmass))
    o->value *= pow(10.0, -0.4 * use->value[0] * o->airmass);
  return UM_OK;
}

const struct um_effect um_effects_extinction = {
    UM_EFFECT_ABI,
    .name = "extinction",
    .summary = "The atmosphere dims the satellite, more toward the horizon",
    .reference = "Kasten & Young 1989, Appl. Opt. 28:4735; Patat et al. 2011, A&A 527:A91",
    .validity =
        "one coefficient a band, over all its wavelengths; acts on irradiance in the order "
        "of the list of effects, not on magnitudes and radiant intensities, which are those "
        "without an atmosphere; "
        "of no effect without a station",
    .separated_by = "zero_point: one pass over a range of airmasses of 2 or more, or standard "
                    "stars at two airmasses in the same night",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
