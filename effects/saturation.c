/* Pixels that are full: of a Gaussian image whose core asks for more than a pixel holds, the wings
 * alone go on growing (optics/instrument/sensor.h). A switch for what sensors state as
 * saturation_e. */
#include "effects/list_impl.h"

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context, (void)use;
  if (o->sensor == NULL || isnan(o->background) || !(o->electrons > 0.0)) return UM_OK;
  double all = o->value * o->electrons;
  double found = um_instrument_saturated(o->sensor, all, o->background);
  if (found < all) o->value = found / o->electrons;
  return UM_OK;
}

const struct um_effect um_effects_saturation = {
    UM_EFFECT_ABI,
    .name = "saturation",
    .summary = "Pixels hold no more than the sensor's saturation_e",
    .reference = "Howell 2006, Handbook of CCD Astronomy, chapter 2",
    .validity = "count rates of sensors with saturation_e and pixel_arcsec; a Gaussian image "
                "centred on a pixel, no charge flows over to neighbours; after all other effects",
    .separated_by = "specular_level, roughness and nonlinearity: a shorter exposure of the same "
                    "glint; or the pictures, whose brightest pixels are alike",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .hooks = {.observation = observation},
};
