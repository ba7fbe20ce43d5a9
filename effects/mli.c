/* Which MLI an effect acts on. */
#include "effects/mli_impl.h"

#include <string.h>

enum um_status um_effects_mli_acts(struct um_context *context, const struct um_effect_use *use,
                                   const char *part, const char *group,
                                   const struct um_thermal_mli *mli, bool *acts)
{
  *acts = false;
  if (!um_effect_acts_on_group(use, part, group)) return UM_OK;
  *acts = mli != NULL;
  if (*acts || use->target == NULL || strcmp(use->target, part) == 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "effect '%s': '%s.%s' has no MLI", use->effect->name,
                      part, group);
}

enum um_status um_effects_mli_check(struct um_context *context, const struct um_effect_use *use,
                                    const char *part, struct um_thermal_part_spec *spec)
{
  if (use->target == NULL || strcmp(use->target, part) != 0) return UM_OK;
  for (size_t g = 0; g < spec->ngroup; g++)
    if (spec->groups[g].mli != NULL) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "effect '%s': the part '%s' has no MLI",
                      use->effect->name, part);
}
