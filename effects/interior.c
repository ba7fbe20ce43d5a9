/* Which interior of a part an effect acts on. */
#include "effects/interior_impl.h"

#include <string.h>

#include "thermal/network/body.h"

enum um_status um_effects_interior_find(struct um_context *context, const struct um_effect_use *use,
                                        const char *part, struct um_thermal_part_spec *spec,
                                        const char *wanted, struct um_thermal_interior_spec **out)
{
  const char *effect = use->effect->name, *name = "interior";
  size_t n = strlen(part);
  *out = NULL;
  if (!um_effect_acts_on(use, part)) {
    if (strncmp(use->target, part, n) != 0 || use->target[n] != '.') return UM_OK;
    name = use->target + n + 1;
  }
  for (size_t i = 0; i < spec->ninterior; i++)
    if (strcmp(spec->interior[i].name, name) == 0) *out = &spec->interior[i];
  if (*out == NULL)
    return um_core_fail(
        context, UM_ERR_INPUT, "effect '%s': the part '%s' has no %s that could %s; accepted: %s",
        effect, part, name, wanted,
        spec->ninterior > 0 ? "PART.NAME of its interiors" : "a part with interior");
  if ((*out)->held > 0.0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect '%s': '%s.%s' is held at %g K and cannot %s; accepted: an interior "
                        "without temperature_K",
                        effect, part, name, (*out)->held, wanted);
  return UM_OK;
}
