/* The built-in effects, from the one list. */
#include <string.h>

#include "effects/effects.h"
#include "effects/list_impl.h"

static const struct um_effect *const list[] = {
#define UM_EFFECT(name) &um_effects_##name,
#include "effects/list.def"
#undef UM_EFFECT
};

size_t um_effects_count(void) { return sizeof list / sizeof list[0]; }

const struct um_effect *um_effects_at(size_t index) { return list[index]; }

const struct um_effect *um_effects_find(const char *name)
{
  for (size_t i = 0; i < um_effects_count(); i++)
    if (strcmp(list[i]->name, name) == 0) return list[i];
  return NULL;
}
