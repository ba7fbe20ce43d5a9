/* An effect that does not exist: what could have been meant, and what there is. */
#include "base/core/suggestions.h"
#include "effects/effects.h"

enum um_status um_effects_registry_refuse(struct um_context *context,
                                          const struct um_effects_registry *registry,
                                          const char *name)
{
  char names[2048], hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  for (size_t i = 0; i < um_effects_registry_count(registry); i++)
    um_core_words_consider(&guess, um_effects_registry_at(registry, i)->name);
  um_effects_registry_names(registry, names, sizeof names);
  return um_core_fail(context, UM_ERR_INPUT, "no effect is called '%.60s'%s; accepted: %.850s",
                      name, um_core_words_hint(&guess, hint), names);
}
