/* From the scenario's parts and material records to the heat network. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/suggestions.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"
#include "model/build/start_offset_group.h"

/* Working arrays of one build; everything in them lives as long as the document. */
struct assembly {
  struct um_context *context;
  struct um_model *model;
  double *group_area; /* [ngroup] one side [m^2] */
};

/* Solar absorptance and total emittance of one side, effects included; zero where there is none.
 * law: how they depend on angle and temperature. */
static void optics_of(const struct um_model *model, uint32_t material, double *absorptance,
                      double *emittance, const struct um_thermal_surface_law **law)
{
  *absorptance = *emittance = 0.0;
  *law = NULL;
  if (material == UM_GEOMETRY_NONE) return;
  const struct um_materials_record *record = model->material[material];
  const struct um_materials_adjustment *adjustment = &model->adjustment[material];
  *absorptance = um_materials_solar_absorptance(record, adjustment);
  *emittance = um_materials_emittance(record, adjustment, UM_REFERENCE_TEMPERATURE);
  *law = model->surface_law[material];
}

/* What covers a group of that name; own: what the part states for it, or NULL. */
static const struct um_scenario_mli *mli_of(const struct um_scenario_part *part,
                                            const struct um_scenario_group *own)
{
  if (own != NULL && own->mli != NULL) return own->mli;
  return own != NULL && own->bare ? NULL : part->mli;
}

/* Area of all groups of a part that a blanket covers [m^2]. */
static double area_under(const struct assembly *a, const struct um_scenario_part *part,
                         uint32_t index, const struct um_scenario_mli *mli)
{
  const struct um_geometry *geometry = a->model->geometry;
  double area = 0.0;
  for (uint32_t g = 0; g < um_geometry_group_count(geometry); g++) {
    const struct um_geometry_group *group = um_geometry_group(geometry, g);
    if (group->part != um_geometry_group(geometry, index)->part) continue;
    if (mli_of(part, um_model_group_named(part, group->name)) == mli) area += a->group_area[g];
  }
  return area;
}

static enum um_status group_of(const struct assembly *a, const struct um_scenario_part *part,
                               uint32_t index, struct um_thermal_group_spec *to)
{
  const struct um_geometry_group *group = um_geometry_group(a->model->geometry, index);
  const struct um_scenario_group *own = um_model_group_named(part, group->name);
  const struct um_scenario_mli *mli = mli_of(part, own);
  to->group = index;
  struct um_thermal_mli *blanket = NULL;
  if (mli != NULL)
    UM_TRY(um_model_build_mli(a->context, a->model, part, mli, area_under(a, part, index, mli),
                              &blanket));
  to->mli = blanket;

  const struct um_scenario_shell *wall =
      own != NULL && own->shell != NULL ? own->shell : part->shell;
  struct um_thermal_shell *shell = NULL;
  if (part->solid == NULL && part->network == NULL) {
    UM_TRY(um_core_arena_allocate(a->context, &a->model->memory, 1, sizeof *shell, &shell));
    if (wall != NULL)
      UM_TRY(um_model_build_shell(a->context, a->model, wall, shell));
    else if (to->mli == NULL || !to->mli->wraps_interior)
      UM_TRY(um_model_build_shell_of_materials(a->context, a->model, part, group, shell));
    to->shell = shell;
  }

  UM_TRY(um_model_build_conductances(a->context, a->model, part, own, to));
  if (own != NULL && own->heat_pipe != NULL) {
    to->heat_pipe_conductance = own->heat_pipe->conductance_W_K;
    to->heat_pipe_capacity = own->heat_pipe->capacity_J_K;
  }
  if (own != NULL) {
    to->power = own->power_W;
    UM_TRY(um_model_power_history(a->context, a->model, &own->at, own->power_file, &to->history));
  }
  optics_of(a->model, group->front_material, &to->absorptance_front, &to->emittance_front,
            &to->law_front);
  optics_of(a->model, group->back_material, &to->absorptance_back, &to->emittance_back,
            &to->law_back);
  to->inside_emittance =
      own != NULL && !isnan(own->inside_emittance) ? own->inside_emittance : part->inside_emittance;
  if (group->front_material != UM_GEOMETRY_NONE) to->extraction_front = part->electrical_extraction;
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(a->model, &i, &use);)
    if (use.effect->hooks.group != NULL)
      UM_TRY(
          use.effect->hooks.group(a->context, &use, part->name, group->name, to, shell, blanket));
  if (to->extraction_front > to->absorptance_front)
    return um_document_mark_fail(
        a->context, &part->at,
        "electrical_extraction %g exceeds the solar absorptance %.3f of '%s'", to->extraction_front,
        to->absorptance_front,
        um_geometry_material_name(a->model->geometry, group->front_material));
  return UM_OK;
}

static enum um_status check_group_names(const struct assembly *a,
                                        const struct um_scenario_part *part, uint32_t index)
{
  const struct um_scenario_group *own = part->groups.items;
  for (size_t k = 0; k < part->groups.count; k++) {
    bool found = false;
    char names[512] = "", hint[UM_CORE_WORDS_HINT];
    struct um_core_words_guess guess = {.written = own[k].name};
    for (size_t g = 0; g < um_geometry_group_count(a->model->geometry); g++) {
      const struct um_geometry_group *group = um_geometry_group(a->model->geometry, g);
      if (group->part != index) continue;
      um_core_words_append(names, sizeof names, group->name);
      um_core_words_consider(&guess, group->name);
      found = found || strcmp(group->name, own[k].name) == 0;
    }
    if (!found)
      return um_model_fail(a->context, &own[k].at, NULL,
                           "the part '%s' has no group '%s'%s; accepted: %s", part->name,
                           own[k].name, um_core_words_hint(&guess, hint), names);
  }
  return UM_OK;
}

static enum um_status part_of(const struct assembly *a, const struct um_scenario_part *part,
                              uint32_t index, struct um_thermal_part_spec *to)
{
  const struct um_geometry *geometry = a->model->geometry;
  struct um_thermal_group_spec *groups = NULL;
  size_t n = 0;
  to->part = index;
  if (a->model->origin != NULL) to->like = a->model->origin->body;
  to->kind = part->lumped ? UM_THERMAL_LUMPED : UM_THERMAL_SHELL;
  if (part->lumped && part->solid != NULL)
    return um_model_fail(a->context, &part->at, "solid",
                         "excludes lumped; accepted: one of the two");
  if (part->solid != NULL) UM_TRY(um_model_build_solid(a->context, a->model, part, to));
  UM_TRY(check_group_names(a, part, index));
  to->start_temperature = isnan(part->start_temperature_K)
                              ? a->model->scenario->thermal->start_temperature_K
                              : part->start_temperature_K;
  UM_TRY(um_model_build_interiors(a->context, a->model, part, index, to));
  if (part->network != NULL) UM_TRY(um_model_build_network(a->context, a->model, part, index, to));
  /* the groups of a part stand together */
  uint32_t first = 0, all = (uint32_t)um_geometry_group_count(geometry), own = 0;
  while (first < all && um_geometry_group(geometry, first)->part != index) first++;
  while (first + own < all && um_geometry_group(geometry, first + own)->part == index) own++;
  UM_TRY(um_core_arena_allocate(a->context, &a->model->memory, own, sizeof *groups, &groups));
  for (; n < own; n++) UM_TRY(group_of(a, part, first + (uint32_t)n, &groups[n]));
  for (size_t i = 0; i < n; i++) to->inside = to->inside || groups[i].inside_emittance > 0.0;
  um_model_share_conductances(a->model, part, a->group_area, groups, n);
  to->groups = groups;
  to->ngroup = n;
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(a->model, &i, &use);)
    if (use.effect->hooks.part != NULL)
      UM_TRY(use.effect->hooks.part(a->context, &use, part->name, to));
  um_model_warn_of_bare_blanket(a->context, a->model, part, groups, n);
  return um_model_check_way_out(a->context, a->model, part, to);
}

/* Exactly one way to say what a contact carries. */
static enum um_status check_contact(const struct assembly *a,
                                    const struct um_scenario_contact *from)
{
  bool product = !isnan(from->area_m2) || !isnan(from->exchange_factor);
  int ways = !isnan(from->conductance_W_K) + !isnan(from->exchange_area_m2) + product;
  if (strcmp(from->a, from->b) == 0)
    return um_model_fail(a->context, &from->at, "b",
                         "'%s' is the same place as a; accepted: another place", from->b);
  if (ways != 1 || (product && isnan(um_scenario_exchange_area(from))))
    return um_model_fail(a->context, &from->at, NULL,
                         "%s - %s: %s; accepted: conductance_W_K, or exchange_area_m2, or area_m2 "
                         "and exchange_factor",
                         from->a, from->b,
                         ways == 0  ? "what it carries is missing"
                         : ways > 1 ? "what it carries is stated more than once"
                                    : "area_m2 and exchange_factor go together");
  return UM_OK;
}

static enum um_status contacts_of(const struct assembly *a, struct um_thermal_contact **out)
{
  const struct um_schema_list *list = &a->model->scenario->contacts;
  const struct um_scenario_contact *from = list->items;
  UM_TRY(um_core_arena_allocate(a->context, &a->model->memory, list->count + 1, sizeof **out, out));
  for (size_t i = 0; i < list->count; i++) {
    double area = um_scenario_exchange_area(&from[i]);
    UM_TRY(check_contact(a, &from[i]));
    (*out)[i] = (struct um_thermal_contact){
        .a = from[i].a,
        .b = from[i].b,
        .conductance = isnan(from[i].conductance_W_K) ? 0.0 : from[i].conductance_W_K,
        .exchange_area = isnan(area) ? 0.0 : area};
  }
  struct um_effect_use use;
  for (size_t k = 0; k < list->count; k++)
    for (size_t i = 0; um_model_effect_next(a->model, &i, &use);)
      if (use.effect->hooks.contact != NULL)
        UM_TRY(use.effect->hooks.contact(a->context, &use, &(*out)[k]));
  return UM_OK;
}

/* The heat network names the contact or the part; its line is ours to add. */
static enum um_status blame_body(struct um_context *context, struct um_model *model,
                                 enum um_status status)
{
  const struct um_scenario_contact *contact = model->scenario->contacts.items;
  for (size_t i = 0; i < model->scenario->contacts.count; i++) {
    char begin[512];
    int n = snprintf(begin, sizeof begin, "contact %s - %s:", contact[i].a, contact[i].b);
    if (n < (int)sizeof begin && strncmp(um_core_message(context), begin, (size_t)n) == 0)
      return um_model_blame(context, &contact[i].at, NULL, status);
  }
  return um_model_blame_part(context, model, status);
}

enum um_status um_model_build_thermal(struct um_context *context, struct um_model *model)
{
  enum um_status status;
  struct assembly a = {context, model, NULL};
  struct um_thermal_part_spec *parts = NULL;
  struct um_thermal_contact *contacts = NULL;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t n = model->scenario->parts.count;
  UM_CHECK(um_model_build_surface_laws(context, model));
  UM_CHECK(um_core_arena_allocate(context, &model->memory, um_geometry_group_count(model->geometry),
                                  sizeof *a.group_area, &a.group_area));
  for (size_t f = 0; f < mesh->nfacet; f++) a.group_area[mesh->facet_group[f]] += mesh->area[f];
  UM_CHECK(um_core_allocate(context, n, sizeof *parts, &parts));
  for (size_t i = 0; i < n; i++)
    UM_CHECK(part_of(&a, (const struct um_scenario_part *)model->scenario->parts.items + i,
                     (uint32_t)i, &parts[i]));
  UM_CHECK(contacts_of(&a, &contacts));
  status = um_thermal_body_create(context, model->geometry, parts, n, contacts,
                                  model->scenario->contacts.count, &model->body);
  if (status == UM_OK) status = um_model_build_start_offset(context, model, parts, n);
  if (status != UM_OK) status = blame_body(context, model, status);
done:
  for (size_t i = 0; parts != NULL && i < n; i++) um_thermal_network_destroy(&parts[i].network);
  um_core_free(context, parts);
  return status;
}
