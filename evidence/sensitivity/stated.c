/* What a scenario states of a target, read from its model, for the callback of an effect
 * (effects/effect.h). A change x of a parameter makes the whole
 *
 *   w + x - x_0,   w x / x_0,   w (1 + x) / (1 + x_0),
 *
 * as the effect adds, scales or stretches, x_0 being its value in the scenario. */
#include "evidence/sensitivity/stated.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"

/* ---- what a scenario states of a target ---- */

static void of_material(const struct um_model *model, struct um_effect_nominal *out)
{
  size_t n = um_geometry_material_count(model->geometry);
  for (size_t m = 0; out->use.target != NULL && m < n; m++) {
    if (strcmp(um_geometry_material_name(model->geometry, m), out->use.target) != 0) continue;
    out->material = model->material[m];
    out->adjustment = &model->adjustment[m];
    return;
  }
}

/* The part of a target "part", "part.group" or "part.NAME" of an interior; *group: of the
 * scenario's own groups, or NULL. */
static const struct um_scenario_part *part_named(const struct um_model *model, const char *target,
                                                 const struct um_scenario_group **group)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  *group = NULL;
  for (size_t i = 0; target != NULL && i < model->scenario->parts.count; i++) {
    size_t n = strlen(part[i].name);
    const struct um_scenario_group *own = part[i].groups.items;
    if (strncmp(part[i].name, target, n) != 0) continue;
    if (target[n] == '\0') return &part[i];
    if (target[n] != '.') continue;
    for (size_t k = 0; k < part[i].groups.count; k++)
      if (strcmp(own[k].name, target + n + 1) == 0) *group = &own[k];
    return &part[i];
  }
  return NULL;
}

/* `interior` by the part's name, others by their own. */
static const struct um_scenario_interior *interior_named(const struct um_scenario_part *part,
                                                         const char *target)
{
  const struct um_scenario_interior *interior = part->interiors.items;
  const char *name = target + strlen(part->name);
  if (*name == '\0') return part->interior;
  for (size_t i = 0; i < part->interiors.count; i++)
    if (strcmp(interior[i].name, name + 1) == 0) return &interior[i];
  return NULL;
}

static void of_part(const struct um_model *model, struct um_effect_nominal *out)
{
  const struct um_scenario_group *group;
  const struct um_scenario_part *part = part_named(model, out->use.target, &group);
  if (part == NULL) return;
  const struct um_scenario_shell *wall =
      group != NULL && group->shell != NULL ? group->shell : part->shell;
  const struct um_scenario_mli *mli = group != NULL && group->mli != NULL ? group->mli : part->mli;
  if (group != NULL && group->mli == NULL && group->bare) mli = NULL;
  const struct um_scenario_interior *interior = interior_named(part, out->use.target);
  if (wall != NULL) {
    out->wall_capacity = wall->areal_heat_capacity_J_m2_K;
    out->wall_conductance = wall->through_conductance_W_m2_K;
  }
  if (mli != NULL) out->mli_emittance = mli->effective_emittance;
  if (interior == NULL) return;
  out->interior_power = interior->power_W;
  out->interior_capacity = interior->capacity_J_K;
  out->has_power_history = interior->power_file != NULL;
}

static void of_scenario(const struct um_scenario *scenario, struct um_effect_nominal *out)
{
  const struct um_scenario_contact *contact = scenario->contacts.items;
  const struct um_scenario_attitude *law = scenario->attitude.items;
  struct um_scenario_turn turn;
  if (scenario->contacts.count == 1) out->contact_conductance = contact[0].conductance_W_K;
  for (size_t i = 0; i < scenario->attitude.count && isnan(out->spin_period); i++)
    if (um_scenario_turn(&law[i], &turn)) out->spin_period = turn.period_s;
  for (size_t i = 0; i < scenario->attitude.count && isnan(out->inertia_ratio); i++)
    if (law[i].spin != NULL) out->inertia_ratio = law[i].spin->inertia_ratio;
}

static struct um_effect_nominal nominal_of(const struct um_sensitivity_forward *forward,
                                           const struct um_effect *effect, const char *target)
{
  const struct um_model *model = forward->model;
  struct um_effect_nominal out = {.use = {.effect = effect, .target = target},
                                  .environment = &model->environment,
                                  .geometry = model->geometry,
                                  .creasing = model->creasing,
                                  .network = model->body == NULL ? NULL : model->body->network,
                                  .infrared_from = NAN,
                                  .infrared_to = NAN,
                                  .wall_capacity = NAN,
                                  .wall_conductance = NAN,
                                  .mli_emittance = NAN,
                                  .interior_power = NAN,
                                  .interior_capacity = NAN,
                                  .contact_conductance = NAN,
                                  .spin_period = NAN,
                                  .inertia_ratio = NAN};
  for (size_t b = model->nband; b-- > 0;) {
    if (model->band[b].from < UM_INFRARED_FROM) continue;
    out.infrared_from = model->band[b].from;
    out.infrared_to = model->band[b].to;
  }
  for (size_t i = 0; i < forward->plan->ntime; i++)
    out.longest_exposure = fmax(out.longest_exposure, forward->plan->exposure[i]);
  of_material(model, &out);
  of_part(model, &out);
  of_scenario(model->scenario, &out);
  return out;
}

/* ---- what an effect makes of it ---- */

bool um_sensitivity_stated_find(const struct um_sensitivity_forward *forward,
                                const struct um_effect *effect, const char *target, size_t p,
                                double null_value, struct um_effect_stated *out)
{
  const struct um_effect_parameter *of = &effect->parameters[p];
  *out = (struct um_effect_stated){.value = NAN, .change = of->change, .null_value = null_value};
  if (of->stated == NULL) return false;
  const struct um_effect_nominal nominal = nominal_of(forward, effect, target);
  of->stated(&nominal, out);
  return isfinite(out->value);
}

double um_sensitivity_stated_whole(const struct um_effect_stated *stated, double value)
{
  double whole = stated->value;
  if (stated->change == UM_CHANGE_ADDS) whole += value - stated->null_value;
  if (stated->change == UM_CHANGE_SCALES) whole *= value / stated->null_value;
  if (stated->change == UM_CHANGE_STRETCHES) whole *= (1.0 + value) / (1.0 + stated->null_value);
  return fmin(fmax(whole, stated->minimum), stated->maximum);
}

void um_sensitivity_stated_range(const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect, const char *target, size_t p,
                                 double null_value, double *minimum, double *maximum)
{
  struct um_effect_stated stated;
  const struct um_effect_parameter *of = &effect->parameters[p];
  *minimum = of->minimum;
  *maximum = of->maximum;
  if (!um_sensitivity_stated_find(forward, effect, target, p, null_value, &stated) ||
      stated.is_clamped)
    return;
  if (stated.change == UM_CHANGE_ADDS) {
    *minimum = fmax(*minimum, null_value - (stated.value - stated.minimum));
    *maximum = fmin(*maximum, null_value + (stated.maximum - stated.value));
  }
  if (stated.change == UM_CHANGE_SCALES && stated.value > 0.0 && null_value > 0.0)
    *maximum = fmin(*maximum, null_value * stated.maximum / stated.value);
  *minimum = fmin(*minimum, null_value);
  *maximum = fmax(*maximum, null_value);
}

const char *um_sensitivity_stated_refusal(const struct um_sensitivity_forward *forward,
                                          const struct um_effect *effect, const char *target)
{
  if (effect->refusal == NULL) return NULL;
  const struct um_effect_nominal nominal = nominal_of(forward, effect, target);
  return effect->refusal(&nominal);
}
