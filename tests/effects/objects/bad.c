/* Shared objects that are to be refused, one by each value of BAD. */
#include "effects/effect.h"

enum { ABI = 1, SIZE, NO_SYMBOL, CLASH, OUTSIDE, NO_HOOK, TWICE, LAYOUT };

static const struct um_effect_parameter parameters[] = {
    {.name = "strength",
     .unit = "1",
     .help = "of the test",
     .null_value = 0.0,
     .default_value = BAD == OUTSIDE ? 3.0 : 1.0,
     .minimum = -1.0,
     .maximum = 2.0,
     .prior_sigma = INFINITY},
};

static enum um_status observation(struct um_context *context, const struct um_effect_use *use,
                                  struct um_effect_observation *o)
{
  (void)context;
  o->value *= 1.0 + use->value[0];
  return UM_OK;
}

#define DESCRIPTOR                                                                                 \
  {                                                                                                \
    .abi_version = BAD == ABI ? UM_EFFECT_ABI_VERSION + 1 : UM_EFFECT_ABI_VERSION,                 \
    .struct_size = BAD == SIZE ? sizeof(struct um_effect) - 8 : sizeof(struct um_effect),          \
    .layout = BAD == LAYOUT ? UM_EFFECT_LAYOUT + 1 : UM_EFFECT_LAYOUT,                             \
    .name = BAD == CLASH ? "zero_point" : "bad", .summary = "A test", .reference = "none",         \
    .validity = "never", .targets = UM_TARGET_GLOBAL, .parameters = parameters, .nparameter = 1,   \
    .hooks = {.observation = BAD == NO_HOOK ? NULL : observation},                                 \
  }

#if BAD == 3
const struct um_effect another_name = DESCRIPTOR;
#elif BAD == 7
static const struct um_effect first = DESCRIPTOR, second = DESCRIPTOR;
const struct um_effect *const um_effect_list[] = {&first, &second, NULL};
#else
const struct um_effect um_effect = DESCRIPTOR;
#endif
