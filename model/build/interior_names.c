/* Interiors of a part: `interior` where it has one, then those of `interiors`. */
#include "model/build/steps_impl.h"

#include <string.h>

#include "base/core/suggestions.h"
#include "model/scenario/fail_group.h"

size_t um_model_interior_count(const struct um_scenario_part *part)
{
  return part->interiors.count + (part->interior != NULL ? 1 : 0);
}

const struct um_scenario_interior *um_model_interior_at(const struct um_scenario_part *part,
                                                        size_t index)
{
  if (part->interior != NULL && index-- == 0) return part->interior;
  return (const struct um_scenario_interior *)part->interiors.items + index;
}

bool um_model_interior_is_solid(const struct um_scenario_part *part)
{
  for (size_t i = 0; i < um_model_interior_count(part); i++)
    if (um_model_interior_at(part, i)->conductivity_W_m_K > 0.0) return true;
  return false;
}

const char *um_model_interior_name(const struct um_scenario_interior *interior)
{
  return interior->name == NULL ? "interior" : interior->name;
}

size_t um_model_interior_find(const struct um_scenario_part *part, const char *name)
{
  for (size_t i = 0; i < um_model_interior_count(part); i++)
    if (strcmp(um_model_interior_name(um_model_interior_at(part, i)), name) == 0) return i;
  return UM_MODEL_NO_INTERIOR;
}

enum um_status um_model_refuse_interior(struct um_context *context,
                                        const struct um_scenario_part *part,
                                        const struct um_mark *at, const char *key, const char *name,
                                        const char *other)
{
  char names[512] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  if (other != NULL) um_core_words_append(names, sizeof names, other);
  for (size_t i = 0; i < um_model_interior_count(part); i++) {
    const char *known = um_model_interior_name(um_model_interior_at(part, i));
    um_core_words_append(names, sizeof names, known);
    um_core_words_consider(&guess, known);
  }
  return um_model_fail(context, at, key, "the part '%s' has no interior '%s'%s; accepted: %s",
                       part->name, name, um_core_words_hint(&guess, hint),
                       *names == '\0' ? "nothing, it has none" : names);
}
