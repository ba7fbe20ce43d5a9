/* Descriptors of the built-in effects, declared from the one list. Private to effects/. */
#ifndef UMBRA_EFFECTS_LIST_IMPL_H
#define UMBRA_EFFECTS_LIST_IMPL_H

#include "effects/effect.h"

#define UM_EFFECT_VISIBLE 0.55e-6 /* wavelength that reflectances are stated at [m] */

/* Hooks of one statement, by the names that they give: a switch of `environment`; what a `use` does
 * to `environment`, to `sky`, to the `adjustment` of a material or to the observation `o` of a band
 * that it acts on. */
#define UM_EFFECT_SWITCH(hook, ...)                                                                \
  static enum um_status hook(struct um_context *context, struct um_environment *environment)       \
  {                                                                                                \
    (void)context;                                                                                 \
    __VA_ARGS__;                                                                                   \
    return UM_OK;                                                                                  \
  }
#define UM_EFFECT_HOOK(hook, thing, ...)                                                           \
  static enum um_status hook(struct um_context *context, const struct um_effect_use *use, thing)   \
  {                                                                                                \
    (void)context;                                                                                 \
    __VA_ARGS__;                                                                                   \
    return UM_OK;                                                                                  \
  }
#define UM_EFFECT_ON_ENVIRONMENT(hook, ...)                                                        \
  UM_EFFECT_HOOK(hook, struct um_environment *environment, __VA_ARGS__)
#define UM_EFFECT_ON_SKY(hook, ...)                                                                \
  UM_EFFECT_HOOK(hook, struct um_environment_clear_sky *sky, __VA_ARGS__)
#define UM_EFFECT_ON_OBSERVATION(hook, ...)                                                        \
  UM_EFFECT_HOOK(hook, struct um_effect_observation *o,                                            \
                 if (um_effect_acts_on(use, o->band)) __VA_ARGS__)
#define UM_EFFECT_ON_MATERIAL(hook, ...)                                                           \
  static enum um_status hook(struct um_context *context, const struct um_effect_use *use,          \
                             const char *material, double t_tai,                                   \
                             struct um_materials_adjustment *adjustment)                           \
  {                                                                                                \
    (void)context, (void)t_tai;                                                                    \
    if (um_effect_acts_on(use, material)) __VA_ARGS__;                                             \
    return UM_OK;                                                                                  \
  }

#define UM_EFFECT(name) extern const struct um_effect um_effects_##name;
#include "effects/list.def"
#undef UM_EFFECT

#endif
