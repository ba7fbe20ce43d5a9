/* Parameters of effects by the names that users write: the present one, and the one before. */
#include <string.h>

#include "base/core/suggestions.h"
#include "effects/effects.h"

static bool is_former(const struct um_effect_parameter *parameter, const char *name)
{
  return parameter->formerly != NULL && strcmp(parameter->formerly, name) == 0;
}

size_t um_effects_parameter_find(const struct um_effect *effect, const char *name)
{
  size_t p = 0;
  while (p < effect->nparameter && strcmp(effect->parameters[p].name, name) != 0 &&
         !is_former(&effect->parameters[p], name))
    p++;
  return p;
}

static enum um_status refuse(struct um_context *context, const struct um_effect *effect,
                             const char *name)
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

enum um_status um_effects_parameter_read(struct um_context *context, const struct um_effect *effect,
                                         const char *name, struct um_effects_said *said,
                                         size_t *out)
{
  size_t p = um_effects_parameter_find(effect, name);
  *out = p;
  if (p == effect->nparameter) return refuse(context, effect, name);
  const struct um_effect_parameter *parameter = &effect->parameters[p];
  if (said->name[p] != NULL && strcmp(said->name[p], name) != 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': %s and %s are one parameter; accepted: %s alone",
                        effect->name, parameter->formerly, parameter->name, parameter->name);
  if (said->name[p] == NULL && is_former(parameter, name))
    um_core_log(context, UM_LOG_WARNING,
                "effect %s: parameter %s is now called %s; the old name is accepted "
                "until " UM_EFFECT_FORMERLY_UNTIL,
                effect->name, name, parameter->name);
  said->name[p] = name;
  return UM_OK;
}
