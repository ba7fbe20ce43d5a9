/* Creases of MLI: a blanket hangs in flat patches that are tilted a little. The tilt's mean square
 * adds to that of the scenario, t^2 = t_0^2 + v, as light goes with it and not with the tilt: in
 * v = 0 the lobe widens by d(alpha^2) = 2 dv (geometry/creases.h). */
#include "base/core/constants.h"
#include "effects/list_impl.h"
#include "geometry/creases.h"

static enum um_status crease(struct um_context *context, const struct um_effect_use *use,
                             const char *part, const char *group,
                             struct um_geometry_creasing *creasing)
{
  if (!um_effect_acts_on_group(use, part, group)) return UM_OK;
  if (creasing == NULL) {
    if (strcmp(use->target, part) == 0) return UM_OK;
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'mli_creases': '%s.%s' has no MLI; accepted: a group with MLI, or "
                        "one that states creases",
                        part, group);
  }
  if (use->value[0] == 0.0) return UM_OK;
  creasing->tilt_square = fmax(0.0, creasing->tilt_square + use->value[0] * UM_DEG * UM_DEG);
  if (use->value[1] > 0.0) creasing->patch = use->value[1];
  return UM_OK;
}

/* The most creased group of a target leads: a flatter one has no less than none. */
static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  const struct um_geometry *g = n->geometry;
  double most = 0.0;
  for (size_t k = 0; k < um_geometry_group_count(g); k++) {
    const struct um_geometry_group *group = um_geometry_group(g, (uint32_t)k);
    if (um_effect_acts_on_group(&n->use, um_geometry_part_name(g, group->part), group->name))
      most = fmax(most, n->creasing[k].tilt_square);
  }
  um_effect_state(out, "mean square of the creases' tilt", "deg^2", most / (UM_DEG * UM_DEG), 0.0,
                  INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "tilt_square_deg2",
     .unit = "deg^2",
     .help = "added to the mean square of the patches' tilt per axis; 9 is 3 deg rms",
     .null_value = 0.0,
     .default_value = 9.0,
     .minimum = -900.0,
     .maximum = 900.0,
     .prior_sigma = 25.0,
     .stated = stated,
     .prior = "tilts of 1 to 10 deg rms"},
    {.name = "patch_m",
     .unit = "m",
     .help = "edge of a patch; 0: the scenario's, or too small to tell apart",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = 0.0,
     .maximum = 10.0,
     .prior_sigma = INFINITY,
     .chosen = true,
     .prior = "0.01 to 0.3 m"},
};

const struct um_effect um_effects_mli_creases = {
    UM_EFFECT_ABI,
    .name = "mli_creases",
    .summary = "Blankets hang in creases: glints of their flat patches come over many directions",
    .reference = "Walter et al. 2007, EGSR; Yan et al. 2014, ACM Trans. Graph. 33:116",
    .validity = "groups with MLI, or with creases that the scenario states; patches are flat "
                "squares of independent tilts, which share their facet's visibility; absorptance "
                "and emittance stay; what mirrors heat does so no more once its lobe is wider "
                "than specular_exchange takes",
    .separated_by = "roughness: glints of single patches, which come again at each turn of the "
                    "satellite; the mean light alone cannot tell",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.creases = crease},
};
