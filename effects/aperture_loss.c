/* Light outside the circle in which counts are summed. Of a Moffat image, (1 + (r/a)^2)^-3, the
 * share (1 + (r/a)^2)^-2 falls outside r; seeing widens it by X^0.6 while the circle stays, so that
 * of a share s at the zenith
 *   s(X) = (1 + (s^(-1/2) - 1) X^-1.2)^-2 = s / (s^(1/2) + (1 - s^(1/2)) X^-1.2)^2
 * is lost at airmass X: hardly more than X^2.4 times as much while it is small. */
#include "effects/list_impl.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "share",
     .unit = "1",
     .help = "of the light that falls outside the circle at the zenith",
     .null_value = 0.0,
     .default_value = 0.05,
     .minimum = 0.0,
     .maximum = 0.9,
     .prior_sigma = 0.05,
     .prior = "a circle of 1 to 2 FWHM loses 6 to 0.4 % of an image's core, and wings beside it"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  double s = use->value[0], root = sqrt(s);
  if (!um_effect_acts_on(use, o->band) || isnan(o->airmass)) return UM_OK;
  double width = root + (1.0 - root) * pow(o->airmass, -1.2);
  o->value *= 1.0 - s / (width * width);
  return UM_OK;
}

const struct um_effect um_effects_aperture_loss = {
    UM_EFFECT_ABI,
    .name = "aperture_loss",
    .summary = "Part of the image falls outside the circle in which its counts are summed",
    .reference = "Moffat 1969, A&A 3:455; Fried 1966, J. Opt. Soc. Am. 56:1372",
    .validity = "a circle of one size over the pass, a Moffat image of exponent 3 as wide as "
                "seeing makes it; acts on irradiance, counts, magnitude and measured radiant "
                "intensity; of no effect without a station",
    .separated_by = "extinction and zero_point: the counts of stars in circles of two sizes, or in "
                    "the same circle at the same airmass",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
