/* Names of effects for messages; and those of effects and parameters that do not exist: what could
 * have been meant, and what there is. */
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

enum um_status um_effects_refuse_parameter(struct um_context *context,
                                           const struct um_effect *effect, const char *name)
{
  char names[512] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  if (effect->nparameter == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s' has no parameters, it is a switch; accepted: none",
                        effect->name);
  for (size_t p = 0; p < effect->nparameter; p++) {
    um_core_words_append(names, sizeof names, effect->parameters[p].name);
    um_core_words_consider(&guess, effect->parameters[p].name);
  }
  return um_core_fail(context, UM_ERR_INPUT, "effect '%s' has no parameter '%.60s'%s; accepted: %s",
                      effect->name, name, um_core_words_hint(&guess, hint), names);
}
