/* Two effects in one shared object. */
#include "effects/effect.h"

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  (void)use;
  o->value *= 2.0;
  return UM_OK;
}

#define EFFECT(name_)                                                                              \
  {                                                                                                \
    UM_EFFECT_ABI, .name = name_, .summary = "Twice as bright", .reference = "none",               \
                   .validity = "in tests", .targets = UM_TARGET_GLOBAL,                            \
                   .hooks = {.observation = observation},                                          \
  }

static const struct um_effect one = EFFECT("twice"), other = EFFECT("twice_more");
const struct um_effect *const um_effect_list[] = {&one, &other, NULL};
