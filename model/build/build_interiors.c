/* What is inside a part: its interiors, what holds them to the walls, and whether heat that they
 * release gets out. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "model/scenario/fail_group.h"

/* A name that no other place of the part has. */
static enum um_status check_name(struct um_context *context, const struct um_model *model,
                                 const struct um_scenario_interior *from, uint32_t part)
{
  static const char *const taken[] = {"interior", "front", "back", "wall", "inside"};
  const char *of = um_model_name_is_plain(from->name) ? NULL : "that cannot stand in a header";
  for (size_t i = 0; of == NULL && i < sizeof taken / sizeof taken[0]; i++)
    if (strcmp(from->name, taken[i]) == 0) of = "that a place of every part may have";
  for (size_t g = 0; of == NULL && g < um_geometry_group_count(model->geometry); g++) {
    const struct um_geometry_group *group = um_geometry_group(model->geometry, g);
    if (group->part == part && strcmp(from->name, group->name) == 0) of = "of a group of the part";
  }
  if (of == NULL) return UM_OK;
  return um_model_fail(context, &from->at, NULL,
                       "'%s' is a name %s; accepted: another one, without . / : , ; and quotes",
                       from->name, of);
}

static enum um_status build_named(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_interior *from, uint32_t part,
                                  struct um_thermal_interior_spec *to)
{
  UM_TRY(check_name(context, model, from, part));
  bool held = from->temperature_K > 0.0;
  if (held && (from->power_W != 0.0 || from->power_file != NULL))
    return um_model_fail(context, &from->at, from->power_file != NULL ? "power_file" : "power_W",
                         "'%s' is held at %g K and takes no power; accepted: temperature_K or "
                         "power",
                         from->name, from->temperature_K);
  if (!held && isnan(from->capacity_J_K))
    return um_model_fail(context, &from->at, NULL,
                         "'%s' has no capacity_J_K; accepted: capacity_J_K, 0 for a node that "
                         "balances at every instant, or temperature_K",
                         from->name);
  if (held) to->held = from->temperature_K;
  if (isnan(to->capacity)) to->capacity = 0.0;
  return UM_OK;
}

enum um_status um_model_build_interiors(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_part *part, uint32_t index,
                                        struct um_thermal_part_spec *to)
{
  size_t n = um_model_interior_count(part);
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *to->interior, &to->interior));
  to->ninterior = n;
  for (size_t i = 0; i < n; i++) {
    const struct um_scenario_interior *from = um_model_interior_at(part, i);
    to->interior[i] =
        (struct um_thermal_interior_spec){.name = um_model_interior_name(from),
                                          .capacity = from->capacity_J_K,
                                          .power = from->power_W,
                                          .conductivity = from->conductivity_W_m_K,
                                          .tetrahedron_size = from->tetrahedron_size_m};
    if (from->name != NULL) UM_TRY(build_named(context, model, from, index, &to->interior[i]));
    UM_TRY(um_model_power_history(context, model, &from->at, from->power_file,
                                  &to->interior[i].history));
  }
  return UM_OK;
}

/* What the group itself states [W/K]; NaN: nothing. */
static double stated(const struct um_scenario_group *own,
                     const struct um_scenario_interior *interior)
{
  if (own == NULL) return NAN;
  if (interior->name == NULL) return own->interior_conductance_W_K;
  const struct um_scenario_inner_conductance *c = own->conductances.items;
  for (size_t i = 0; i < own->conductances.count; i++)
    if (strcmp(c[i].name, interior->name) == 0) return c[i].conductance_W_K;
  return NAN;
}

enum um_status um_model_build_conductances(struct um_context *context, struct um_model *model,
                                           const struct um_scenario_part *part,
                                           const struct um_scenario_group *own,
                                           struct um_thermal_group_spec *to)
{
  size_t n = um_model_interior_count(part);
  const struct um_scenario_inner_conductance *c = own == NULL ? NULL : own->conductances.items;
  if (own != NULL && !isnan(own->interior_conductance_W_K) && part->interior == NULL)
    return um_document_mark_fail(context, &own->at,
                                 "interior_conductance_W_K, but the part '%s' has no interior",
                                 part->name);
  for (size_t i = 0; c != NULL && i < own->conductances.count; i++) {
    size_t at = um_model_interior_find(part, c[i].name);
    if (at == UM_MODEL_NO_INTERIOR)
      return um_model_refuse_interior(context, part, &c[i].at, NULL, c[i].name, NULL);
    if (um_model_interior_at(part, at)->name == NULL)
      return um_model_fail(context, &c[i].at, NULL,
                           "'interior' has a key of its own; accepted: interior_conductance_W_K");
  }
  if (n == 0) return UM_OK;
  UM_TRY(um_core_arena_allocate(context, &model->memory, n, sizeof *to->interior_conductance,
                                &to->interior_conductance));
  for (size_t i = 0; i < n; i++) {
    double own_value = stated(own, um_model_interior_at(part, i));
    if (!isnan(own_value)) to->interior_conductance[i] = own_value;
  }
  return UM_OK;
}

static void share(const struct um_model *model, const struct um_scenario_part *part,
                  const double *group_area, size_t interior, struct um_thermal_group_spec *groups,
                  size_t n)
{
  const struct um_scenario_interior *from = um_model_interior_at(part, interior);
  double total = 0.0;
  if (!(from->conductance_W_K > 0.0)) return;
  for (int pass = 0; pass < 2; pass++)
    for (size_t i = 0; i < n; i++) {
      const char *name = um_geometry_group(model->geometry, groups[i].group)->name;
      if (!isnan(stated(um_model_group_named(part, name), from))) continue;
      double area = group_area[groups[i].group];
      if (pass == 0)
        total += area;
      else
        groups[i].interior_conductance[interior] = from->conductance_W_K * area / total;
    }
}

void um_model_share_conductances(const struct um_model *model, const struct um_scenario_part *part,
                                 const double *group_area, struct um_thermal_group_spec *groups,
                                 size_t n)
{
  for (size_t i = 0; i < um_model_interior_count(part); i++)
    share(model, part, group_area, i, groups, n);
}

/* --- ways out -------------------------------------------------------------------------------- */

/* The interior of this part that the place of a contact is; UM_MODEL_NO_INTERIOR: another place. */
static size_t inside(const struct um_scenario_part *part, const char *place)
{
  size_t n = strlen(part->name);
  if (strncmp(place, part->name, n) != 0 || place[n] != '.') return UM_MODEL_NO_INTERIOR;
  return um_model_interior_find(part, place + n + 1);
}

/* Held by itself, by the walls or by a blanket around it. */
static bool is_held(const struct um_thermal_part_spec *to, size_t interior)
{
  bool held = to->interior[interior].held > 0.0;
  for (size_t g = 0; g < to->ngroup && !held; g++)
    held = to->groups[g].interior_conductance[interior] > 0.0 ||
           (to->groups[g].mli != NULL && to->groups[g].mli->wraps_interior &&
            to->groups[g].mli->interior == interior);
  return held;
}

/* Contacts carry what is held on to the interiors that they join. */
static void follow_contacts(const struct um_model *model, const struct um_scenario_part *part,
                            size_t n, bool *held)
{
  const struct um_scenario_contact *contact = model->scenario->contacts.items;
  for (bool more = true; more;) {
    more = false;
    for (size_t i = 0; i < model->scenario->contacts.count; i++) {
      size_t a = inside(part, contact[i].a), b = inside(part, contact[i].b);
      if (!(contact[i].conductance_W_K > 0.0 || um_scenario_exchange_area(&contact[i]) > 0.0))
        continue;
      bool reached = (a >= n || held[a]) || (b >= n || held[b]);
      if (a < n && reached && !held[a]) more = held[a] = true;
      if (b < n && reached && !held[b]) more = held[b] = true;
    }
  }
}

static enum um_status refuse_way_out(struct um_context *context,
                                     const struct um_scenario_part *part, size_t interior,
                                     const struct um_thermal_interior_spec *to)
{
  const struct um_scenario_interior *from = um_model_interior_at(part, interior);
  const char *key = from->name == NULL ? "interior_conductance_W_K" : "conductances_W_K";
  if (to->capacity == 0.0)
    return um_model_fail(context, &from->at, "capacity_J_K",
                         "0, and nothing holds the temperature of %s.%s; accepted: "
                         "conductance_W_K above 0, groups with %s, mli that wraps it, or a contact "
                         "that leads on to a wall",
                         part->name, to->name, key);
  return um_model_fail(context, &from->at, from->power_file != NULL ? "power_file" : "power_W",
                       "%g W have no way out of the interior; accepted: conductance_W_K above 0, "
                       "groups with %s, mli that wraps the interior, or a contact of %s.%s",
                       to->power, key, part->name, to->name);
}

enum um_status um_model_check_way_out(struct um_context *context, const struct um_model *model,
                                      const struct um_scenario_part *part,
                                      const struct um_thermal_part_spec *to)
{
  bool *held = NULL;
  enum um_status status = UM_OK;
  if (part->network != NULL) return UM_OK; /* its solution says what nothing holds */
  UM_TRY(um_core_allocate(context, to->ninterior, sizeof *held, &held));
  for (size_t i = 0; i < to->ninterior; i++) held[i] = is_held(to, i);
  follow_contacts(model, part, to->ninterior, held);
  for (size_t i = 0; i < to->ninterior && status == UM_OK; i++) {
    const struct um_thermal_interior_spec *interior = &to->interior[i];
    if (held[i]) continue;
    if (interior->capacity == 0.0 || interior->power > 0.0 || interior->history != NULL)
      status = refuse_way_out(context, part, i, interior);
  }
  um_core_free(context, held);
  return status;
}
