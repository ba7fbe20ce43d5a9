/* Sunlight and moonlight that the air scatters, from a part of the sky beside the satellite that
 * was not subtracted,
 *   E' = E + Omega L,   L = int T(lambda) L(lambda) d lambda,
 * L(lambda) of environment/sky_light.c toward the satellite at that instant. */
#include "base/core/constants.h"
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "area_arcsec2",
     .unit = "arcsec^2",
     .help = "of sky whose light is left in what is measured",
     .null_value = 0.0,
     .default_value = 1.0,
     .minimum = 0.0,
     .maximum = 1e6,
     .prior_sigma = INFINITY,
     .prior = "the whole circle without subtraction, some percent of it with: none"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  const double arcsec = UM_DEG / 3600.0;
  if (um_effect_acts_on(use, o->band) && o->sky > 0.0)
    o->value += use->value[0] * arcsec * arcsec * o->sky;
  return UM_OK;
}

const struct um_effect um_effects_twilight = {
    UM_EFFECT_ABI,
    .name = "twilight",
    .summary =
        "Sunlight that the air scatters, by day and at twilight, is left in what is measured",
    .reference = "Rozenberg 1966, Twilight; Patat, Ugolnikov & Postylyakov 2006, A&A 455:385",
    .validity = "where observer.air states a profile, not a file; 0.30-1.20 um; the Sun down to 15 "
                "deg below the horizon, within 0.5 mag of zeniths that were measured; acts on "
                "irradiance, counts, measured radiant intensity and magnitude (there the same at "
                "every wavelength) in the order of the list of effects. What the light does to "
                "noise and background of counts needs no effect: it is there with the atmosphere",
    .separated_by = "background and sky_background: frames over an hour of twilight, in which it "
                    "fades by a factor of 3 for every degree that the Sun goes down",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
