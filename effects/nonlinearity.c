/* A detector that answers less the more light falls on it, E' = E/(1 + s E/E_5), or more, E' = E (1
 * - s E/E_5) for s < 0; E_5 the irradiance of AB magnitude 5. Dead time of a counter and the bend
 * of a well that fills have this form to first order. */
#include "effects/list_impl.h"

#define LEVEL 0.01 /* of magnitude 5, of magnitude 0 */

static const struct um_effect_parameter parameters[] = {
    {.name = "share",
     .unit = "1",
     .help = "by which a source of AB magnitude 5 reads too low; below 0: too high",
     .null_value = 0.0,
     .default_value = 0.02,
     .minimum = -10.0,
     .maximum = 1e6,
     .prior_sigma = INFINITY,
     .prior = "depends on the instrument: 1 % of a full pixel as sold, 5 % uncorrected"},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  double bent = use->value[0] * o->value / (LEVEL * o->zero);
  if (!um_effect_acts_on(use, o->band) || !(o->value > 0.0)) return UM_OK;
  o->value *= bent > 0.0 ? 1.0 / (1.0 + bent) : 1.0 - bent;
  return UM_OK;
}

const struct um_effect um_effects_nonlinearity = {
    UM_EFFECT_ABI,
    .name = "nonlinearity",
    .summary = "The detector does not answer in proportion to the light",
    .reference = "Howell 2006, Handbook of CCD Astronomy, chapter 2",
    .validity = "a share small against 1 at the brightest; goes with the light of the whole image, "
                "as if images had one width; in the order of the list of effects",
    .separated_by = "specular_level and roughness: a glint in two exposure times; the shorter one "
                    "fills the pixels less",
    .targets = UM_TARGET_GLOBAL | UM_TARGET_BAND,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.observation = observation},
};
