/* Heat capacity of walls, solids and MLI, its skin and what sheets under it store: f C dT/dt = q.
 * It acts in transients alone, with the time constant
 *
 *   tau = f C / (4 eps sigma T^3);
 *
 * a steady state does not feel it. The interior node keeps its capacity: it is another mass with
 * another time constant. */
#include "effects/list_impl.h"
#include "thermal/network/body.h"

static enum um_status scale_group(struct um_context *context, const struct um_effect_use *use,
                                  const char *part, const char *group,
                                  struct um_thermal_group_spec *spec, struct um_thermal_shell *wall,
                                  struct um_thermal_mli *mli)
{
  (void)spec;
  if (!um_effect_acts_on_group(use, part, group)) return UM_OK;
  double capacity = 0.0;
  if (wall != NULL) capacity += wall->areal_heat_capacity *= use->value[0];
  if (mli != NULL) capacity += mli->areal_heat_capacity *= use->value[0];
  if (mli != NULL) mli->sheet_heat_capacity *= use->value[0];
  if (use->target == NULL || strcmp(use->target, part) == 0 || capacity > 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'heat_capacity': '%s.%s' has no wall or MLI with a heat capacity",
                      part, group);
}

/* Solids have theirs in the volume. A part that is named has a capacity somewhere. */
static enum um_status scale_part(struct um_context *context, const struct um_effect_use *use,
                                 const char *part, struct um_thermal_part_spec *spec)
{
  if (!um_effect_acts_on(use, part)) return UM_OK;
  if (spec->kind == UM_THERMAL_SOLID) {
    spec->specific_heat *= use->value[0];
    return UM_OK;
  }
  if (use->target == NULL) return UM_OK;
  for (size_t g = 0; g < spec->ngroup; g++) {
    const struct um_thermal_group_spec *group = &spec->groups[g];
    if (group->shell != NULL && group->shell->areal_heat_capacity > 0.0) return UM_OK;
    if (group->mli != NULL && group->mli->areal_heat_capacity > 0.0) return UM_OK;
  }
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'heat_capacity': the walls of the part '%s' have no heat capacity",
                      part);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "heat capacity of the wall", "J/m^2/K", n->wall_capacity * out->null_value,
                  0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the heat capacity of walls, solids and MLI",
     .null_value = 1.0,
     .default_value = 1.5,
     .minimum = 0.05,
     .maximum = 20.0,
     .prior_sigma = 0.6,
     .logarithmic = true,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "panels 2000 to 10000, MLI 20 to 100 J/m^2/K, a factor of 2 either way",
     .formerly = "capacity_factor"},
};

const struct um_effect um_effects_heat_capacity = {
    UM_EFFECT_ABI,
    .name = "heat_capacity",
    .summary = "Walls hold more or less heat than stated",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 15",
    .validity = "walls, solids and MLI, not the interior; nothing to see in a steady state",
    .separated_by = "emittance: the slope of a temperature at shadow entry and its lag behind the "
                    "spin go with 1/C, the value late in the eclipse does not",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = scale_group, .part = scale_part},
};
