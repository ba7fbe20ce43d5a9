/* An effect under which a material emits ever less: eps(t) = eps (1 - k (t - t_0)). */
#include "effects/effect.h"

static const struct um_effect_parameter parameters[] = {
    {.name = "loss_per_s",
     .unit = "1/s",
     .help = "of the emittance",
     .null_value = 0.0,
     .default_value = 1e-3,
     .minimum = -1.0,
     .maximum = 1.0,
     .prior_sigma = INFINITY},
};

static enum um_status material(struct um_context *context, const struct um_effect_use *use,
                               const char *name, double t_tai,
                               struct um_materials_adjustment *adjustment)
{
  (void)context;
  if (um_effect_acts_on(use, name))
    adjustment->emittance_scale *= 1.0 - use->value[0] * (t_tai - use->epoch);
  return UM_OK;
}

const struct um_effect um_effect = {
    UM_EFFECT_ABI,
    .name = "fading",
    .summary = "A surface emits ever less",
    .reference = "none",
    .validity = "in tests",
    .targets = UM_TARGET_MATERIAL,
    .parameters = parameters,
    .nparameter = 1,
    .hooks = {.material = material},
};
