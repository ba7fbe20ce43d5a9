/* Heat capacity of walls and solids that goes with temperature, beside what their records say:
 *
 *   C(T) = C (1 + k (T - 300 K)).
 *
 * Solids hold less the colder they are (Debye): aluminium loses a tenth from 300 to 220 K, and a
 * cold panel follows its loads faster than one capacity has it. */
#include "effects/list_impl.h"
#include "thermal/network/body.h"

static bool holds(const struct um_thermal_group_spec *group)
{
  return group->shell != NULL && group->shell->areal_heat_capacity > 0.0;
}

static enum um_status add_group(struct um_context *context, const struct um_effect_use *use,
                                const char *part, const char *group,
                                struct um_thermal_group_spec *spec, struct um_thermal_shell *wall,
                                struct um_thermal_mli *mli)
{
  (void)mli;
  if (!um_effect_acts_on_group(use, part, group)) return UM_OK;
  if (wall != NULL) wall->law.capacity_slope += use->value[0];
  if (use->target == NULL || strcmp(use->target, part) == 0 || holds(spec)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'specific_heat_law': '%s.%s' has no wall with a heat capacity", part,
                      group);
}

/* Solids have theirs in the volume. A part that is named has a capacity somewhere. */
static enum um_status add_part(struct um_context *context, const struct um_effect_use *use,
                               const char *part, struct um_thermal_part_spec *spec)
{
  if (!um_effect_acts_on(use, part)) return UM_OK;
  if (spec->kind == UM_THERMAL_SOLID) {
    spec->law.capacity_slope += use->value[0];
    return UM_OK;
  }
  if (use->target == NULL) return UM_OK;
  for (size_t g = 0; g < spec->ngroup; g++)
    if (holds(&spec->groups[g])) return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "effect 'specific_heat_law': the walls of the part '%s' have no heat capacity", part);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "slope_per_K",
     .unit = "1/K",
     .help = "k of C (1 + k (T - 300 K)), of walls and solids",
     .null_value = 0.0,
     .default_value = 0.001,
     .minimum = -0.003,
     .maximum = 0.003,
     .prior_sigma = 0.001,
     .prior = "aluminium 0.0013, polymers and composites 0.002 to 0.003 at 250 K, as stated 0"},
};

const struct um_effect um_effects_specific_heat_law = {
    UM_EFFECT_ABI,
    .name = "specific_heat_law",
    .summary = "Walls hold less heat cold than warm, or more",
    .reference = "Touloukian and Buyco 1970, Thermophysical Properties of Matter 4 and 5",
    .validity = "walls and solids, not skins of MLI and not the interior; a twentieth of C is left "
                "at least; nothing to see in a steady state",
    .separated_by = "heat_capacity: the same factor warm and cold; the slopes of a temperature "
                    "after sunrise and late in the eclipse tell them apart",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = add_group, .part = add_part},
};
