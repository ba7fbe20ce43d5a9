/* What an effect may be attached to in a model that is built: parts, their groups where there is
 * more than one, the interiors that a part lists in place of one, materials, bands; for contacts
 * the places they join. One thing under two names is listed once. */
#include "evidence/sensitivity/targets_impl.h"

#include <stdint.h>
#include <string.h>

#include "effects/effects.h"
#include "thermal/network/body.h"

static enum um_status add(struct um_context *context, struct um_sensitivity_targets *to,
                          const char *part, const char *group)
{
  char *text = NULL;
  if (part != NULL)
    UM_TRY(um_core_asprintf(context, &text, "%s%s%s", part, group != NULL ? "." : "",
                            group != NULL ? group : ""));
  enum um_status status = um_core_reallocate(context, to->count + 1, sizeof *to->name, &to->name);
  if (status != UM_OK) {
    um_core_free(context, text);
    return status;
  }
  to->name[to->count++] = text;
  return UM_OK;
}

static const struct um_scenario_part *scenario_part(const struct um_model *model, const char *name)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  while (strcmp(part->name, name) != 0) part++;
  return part;
}

/* Those whose temperature is computed. */
static enum um_status add_interiors(struct um_context *context, const struct um_scenario_part *part,
                                    struct um_sensitivity_targets *to)
{
  const struct um_scenario_interior *interior = part->interiors.items;
  for (size_t i = 0; i < part->interiors.count; i++)
    if (!(interior[i].temperature_K > 0.0)) UM_TRY(add(context, to, part->name, interior[i].name));
  return UM_OK;
}

static enum um_status add_parts(struct um_context *context, const struct um_model *model,
                                uint32_t targets, struct um_sensitivity_targets *to)
{
  const struct um_geometry *g = model->geometry;
  for (size_t p = 0; p < um_geometry_part_count(g); p++) {
    size_t groups = 0;
    for (size_t k = 0; k < um_geometry_group_count(g); k++)
      groups += um_geometry_group(g, k)->part == p;
    const struct um_scenario_part *part = scenario_part(model, um_geometry_part_name(g, p));
    bool sides = (targets & UM_TARGET_PART_SIDE) != 0, inside = (targets & UM_TARGET_INTERIOR) != 0;
    bool several = inside && part->interiors.count > 0;
    /* the part's name is that of its walls where those are places, too */
    if ((targets & UM_TARGET_PART) != 0 && (sides || !several || part->interior != NULL))
      UM_TRY(add(context, to, um_geometry_part_name(g, p), NULL));
    if (sides && inside && part->interior != NULL && !(part->interior->temperature_K > 0.0))
      UM_TRY(add(context, to, part->name, "interior"));
    if (several) UM_TRY(add_interiors(context, part, to));
    if (!sides) continue;
    if (groups < 2 && (targets & UM_TARGET_PART) != 0) continue;
    for (size_t k = 0; k < um_geometry_group_count(g); k++)
      if (um_geometry_group(g, k)->part == p)
        UM_TRY(add(context, to, um_geometry_part_name(g, p), um_geometry_group(g, k)->name));
  }
  return UM_OK;
}

/* --- contacts -------------------------------------------------------------------------------- */

/* Does a use on this target, with default value, change the contact? */
static enum um_status touches(struct um_context *context, const struct um_effect *effect,
                              const char *target, const struct um_scenario_contact *from, bool *out)
{
  double value[UM_EFFECT_PARAMETERS_MAX] = {0};
  /* a radiating contact has no conductance to change */
  double conductance = isnan(from->conductance_W_K) ? 0.0 : from->conductance_W_K;
  struct um_thermal_contact contact = {.a = from->a, .b = from->b, .conductance = conductance};
  for (size_t p = 0; p < effect->nparameter; p++) value[p] = effect->parameters[p].default_value;
  const struct um_effect_use use = {.effect = effect, .target = target, .value = value};
  UM_TRY(effect->hooks.contact(context, &use, &contact));
  *out = contact.conductance != conductance;
  return UM_OK;
}

/* Add a place unless it touches no contact, or the same ones as a place before. set: [room]
 * [ncontact]. */
static enum um_status add_place(struct um_context *context, const struct um_model *model,
                                const struct um_effect *effect, const char *part, const char *side,
                                bool *set, struct um_sensitivity_targets *to)
{
  const struct um_scenario_contact *contact = model->scenario->contacts.items;
  size_t n = model->scenario->contacts.count;
  bool *own = set + to->count * n, any = false;
  UM_TRY(add(context, to, part, side));
  for (size_t i = 0; i < n; i++) {
    UM_TRY(touches(context, effect, to->name[to->count - 1], &contact[i], &own[i]));
    any = any || own[i];
  }
  for (size_t k = 0; any && k + 1 < to->count; k++)
    any = memcmp(set + k * n, own, n * sizeof *own) != 0;
  if (!any) um_core_free(context, to->name[--to->count]);
  return UM_OK;
}

/* Parts, then the places of contacts. Where there is one contact: only NULL, everything. */
static enum um_status add_contacts(struct um_context *context, const struct um_model *model,
                                   const struct um_effect *effect,
                                   struct um_sensitivity_targets *to)
{
  enum um_status status = UM_OK;
  const struct um_geometry *g = model->geometry;
  const struct um_scenario_contact *contact = model->scenario->contacts.items;
  size_t n = model->scenario->contacts.count, parts = um_geometry_part_count(g);
  bool *set = NULL;
  if (n == 0) return UM_OK;
  if (n == 1 && (effect->targets & UM_TARGET_GLOBAL) != 0) return add(context, to, NULL, NULL);
  UM_CHECK(um_core_allocate(context, (1 + parts + 2 * n) * n, sizeof *set, &set));
  for (size_t p = 0; p < parts; p++)
    UM_CHECK(add_place(context, model, effect, um_geometry_part_name(g, p), NULL, set, to));
  for (size_t i = 0; (effect->targets & UM_TARGET_PART_SIDE) != 0 && i < n; i++) {
    if (strchr(contact[i].a, '.') != NULL)
      UM_CHECK(add_place(context, model, effect, contact[i].a, NULL, set, to));
    if (strchr(contact[i].b, '.') != NULL)
      UM_CHECK(add_place(context, model, effect, contact[i].b, NULL, set, to));
  }
done:
  um_core_free(context, set);
  return status;
}

/* --- environment ----------------------------------------------------------------------------- */

/* Does a use leave the environment, which is all that it acts on, as it is? With default values, or
 * a prior width from nothing where these do nothing. */
static enum um_status leaves_environment(struct um_context *context, const struct um_model *model,
                                         const struct um_effect *effect, bool *out)
{
  static const struct um_effect_hooks none;
  struct um_effect_hooks rest = effect->hooks;
  struct um_environment changed;
  double value[UM_EFFECT_PARAMETERS_MAX] = {0};
  rest.environment = NULL;
  *out = false;
  if (effect->on_by_default || effect->hooks.environment == NULL ||
      memcmp(&rest, &none, sizeof rest) != 0)
    return UM_OK;
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *of = &effect->parameters[p];
    bool idle = of->default_value == of->null_value;
    value[p] = of->default_value + (idle ? of->prior_sigma : 0.0);
  }
  const struct um_effect_use use = {.effect = effect, .value = value};
  memcpy(&changed, &model->environment, sizeof changed);
  if (effect->hooks.environment(context, &use, &changed) != UM_OK) { /* refused: said elsewhere */
    um_core_message_clear(context);
    return UM_OK;
  }
  *out = memcmp(&changed, &model->environment, sizeof changed) == 0; /* NOLINT: copied whole */
  return UM_OK;
}

/* --- sets of measurements -------------------------------------------------------------------- */

/* Is this band, or NULL: anything, measured in the set? */
static bool is_measured(const struct um_sensitivity_forward *f, const char *band, size_t set)
{
  const struct um_compare_measurements *m = f->measurements;
  for (size_t c = 0; c < m->nchannel; c++) {
    if (m->channel[c].set != set || f->plan->source[c] == UM_COMPARE_NOWHERE) continue;
    if (band == NULL) return true;
    if (m->channel[c].quantity != UM_QUANTITY_TEMPERATURE &&
        strcmp(f->model->band[um_compare_band(f->plan, f->model, c)].name, band) == 0)
      return true;
  }
  return false;
}

/* What is measured in several sets may be off in one. */
static enum um_status add_sets(struct um_context *context, const struct um_sensitivity_forward *f,
                               const struct um_effect *effect, struct um_sensitivity_targets *to)
{
  const struct um_compare_measurements *m = f->measurements;
  size_t places = um_effects_may_be_of_a_set(effect) && m->nfile > 1 ? to->count : 0;
  for (size_t k = 0; k < places; k++) {
    size_t sets = 0;
    for (size_t i = 0; i < m->nfile; i++) sets += is_measured(f, to->name[k], i);
    for (size_t i = 0; i < m->nfile && sets > 1; i++) {
      char *text = NULL;
      if (!is_measured(f, to->name[k], i)) continue;
      UM_TRY(um_core_asprintf(context, &text, "%s@%s",
                              to->name[k] != NULL ? to->name[k] : UM_EFFECTS_ALL, m->file[i].name));
      enum um_status status = add(context, to, text, NULL);
      um_core_free(context, text);
      UM_TRY(status);
    }
  }
  return UM_OK;
}

/* --- all ------------------------------------------------------------------------------------- */

static enum um_status fill(struct um_context *context, const struct um_model *model,
                           const struct um_effect *effect, struct um_sensitivity_targets *to)
{
  const struct um_geometry *g = model->geometry;
  uint32_t targets = effect->targets;
  bool nothing;
  if (effect->hooks.contact != NULL) return add_contacts(context, model, effect, to);
  UM_TRY(leaves_environment(context, model, effect, &nothing));
  if (nothing) return UM_OK;
  if ((targets & (UM_TARGET_PART | UM_TARGET_PART_SIDE)) != 0)
    UM_TRY(add_parts(context, model, targets, to));
  for (size_t m = 0; (targets & UM_TARGET_MATERIAL) != 0 && m < um_geometry_material_count(g); m++)
    UM_TRY(add(context, to, um_geometry_material_name(g, m), NULL));
  if ((targets & UM_TARGET_BAND) != 0 && (model->nband > 1 || (targets & UM_TARGET_GLOBAL) == 0))
    for (size_t b = 0; b < model->nband; b++) UM_TRY(add(context, to, model->band[b].name, NULL));
  if (to->count == 0 && (targets & UM_TARGET_GLOBAL) != 0) return add(context, to, NULL, NULL);
  return UM_OK;
}

enum um_status um_sensitivity_targets_of(struct um_context *context, const struct um_model *model,
                                         const struct um_effect *effect,
                                         struct um_sensitivity_targets *out)
{
  *out = (struct um_sensitivity_targets){0};
  enum um_status status = fill(context, model, effect, out);
  if (status != UM_OK) um_sensitivity_targets_release(context, out);
  return status;
}

enum um_status um_sensitivity_targets_create(struct um_context *context,
                                             const struct um_sensitivity_forward *forward,
                                             const struct um_effect *effect,
                                             struct um_sensitivity_targets *out)
{
  UM_TRY(um_sensitivity_targets_of(context, forward->model, effect, out));
  enum um_status status = add_sets(context, forward, effect, out);
  if (status != UM_OK) um_sensitivity_targets_release(context, out);
  return status;
}

void um_sensitivity_targets_release(struct um_context *context,
                                    struct um_sensitivity_targets *targets)
{
  for (size_t i = 0; i < targets->count; i++) um_core_free(context, targets->name[i]);
  um_core_free(context, targets->name);
  *targets = (struct um_sensitivity_targets){0};
}
