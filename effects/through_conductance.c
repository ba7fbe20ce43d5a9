/* Conductance through a wall from front to back, q = f U (T_front - T_back): the honeycomb core of
 * a solar array. In sunlight the front is hot and the back cool, in steady darkness both are alike.
 */
#include <math.h>

#include "effects/list_impl.h"
#include "thermal/network/body.h"

/* A group whose wall has two layers: a back that radiates and a finite conductance to it. */
static bool has_two_layers(const struct um_thermal_group_spec *spec)
{
  return spec->shell != NULL && isfinite(spec->shell->through_conductance) &&
         spec->emittance_back > 0.0;
}

static enum um_status scale(struct um_context *context, const struct um_effect_use *use,
                            const char *part, const char *group, struct um_thermal_group_spec *spec,
                            struct um_thermal_shell *wall, struct um_thermal_mli *mli)
{
  (void)mli;
  if (!um_effect_acts_on_group(use, part, group)) return UM_OK;
  if (wall != NULL) wall->through_conductance *= use->value[0]; /* INFINITY stays */
  if (use->target == NULL || strcmp(use->target, part) == 0 || has_two_layers(spec)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'through_conductance': the wall of '%s.%s' is one layer; accepted: a "
                      "wall with a back and a through_conductance_W_m2_K",
                      part, group);
}

/* A part that is named has such a wall somewhere. */
static enum um_status check(struct um_context *context, const struct um_effect_use *use,
                            const char *part, struct um_thermal_part_spec *spec)
{
  if (use->target == NULL || strcmp(use->target, part) != 0) return UM_OK;
  for (size_t g = 0; g < spec->ngroup; g++)
    if (has_two_layers(&spec->groups[g])) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'through_conductance': the walls of the part '%s' are one layer; "
                      "accepted: a wall with a back and a through_conductance_W_m2_K",
                      part);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "conductance through the wall", "W/m^2/K",
                  n->wall_conductance * out->null_value, 0.0, INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the conductance through the wall that the scenario states",
     .null_value = 1.0,
     .default_value = 2.0,
     .minimum = 0.01,
     .maximum = 100.0,
     .prior_sigma = 1.0,
     .logarithmic = true,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "honeycomb 20 to 200 W/m^2/K about 63, a factor of 3 either way",
     .formerly = "conductance_factor"},
};

const struct um_effect um_effects_through_conductance = {
    UM_EFFECT_ABI,
    .name = "through_conductance",
    .summary = "A panel conducts better or worse from front to back than stated",
    .reference = "Swann & Pittman 1961, NASA TN D-714",
    .validity = "walls of two layers, with a back and a finite conductance through the wall",
    .separated_by = "heat_capacity: temperatures of front and back at once, or passes that show "
                    "front and back at equal phase, in sunlight and in steady darkness",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = scale, .part = check},
};
