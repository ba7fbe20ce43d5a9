/* Surfaces of tilted patches, as effects change them. */
#include "effects/tilts_impl.h"

#include "base/core/constants.h"

enum um_status um_effects_tilt(struct um_context *context, const struct um_effect_use *use,
                               const char *part, const char *group,
                               struct um_geometry_creasing *creasing)
{
  (void)context;
  if (!um_effect_acts_on_group(use, part, group) || use->value[0] == 0.0) return UM_OK;
  creasing->tilt_square = fmax(0.0, creasing->tilt_square + use->value[0] * UM_DEG * UM_DEG);
  if (use->value[1] > 0.0) creasing->patch = use->value[1];
  return UM_OK;
}

void um_effects_tilt_state(const struct um_effect_nominal *n, bool sheet, const char *what,
                           struct um_effect_stated *out)
{
  const struct um_geometry *g = n->geometry;
  double most = 0.0;
  for (size_t k = 0; k < um_geometry_group_count(g); k++) {
    const struct um_geometry_group *group = um_geometry_group(g, (uint32_t)k);
    if (n->creasing[k].sheet == sheet &&
        um_effect_acts_on_group(&n->use, um_geometry_part_name(g, group->part), group->name))
      most = fmax(most, n->creasing[k].tilt_square);
  }
  um_effect_state(out, what, "deg^2", most / (UM_DEG * UM_DEG), 0.0, INFINITY);
}
