/* Walls of a part: shells, blankets, solids. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

const struct um_scenario_group *um_model_group_named(const struct um_scenario_part *part,
                                                     const char *name)
{
  const struct um_scenario_group *groups = part->groups.items;
  for (size_t i = 0; i < part->groups.count; i++)
    if (strcmp(groups[i].name, name) == 0) return &groups[i];
  return NULL;
}

/* Wall by explicit numbers, or by a bulk material and a thickness. */
enum um_status um_model_build_shell(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_shell *from,
                                    struct um_thermal_shell *to)
{
  to->front_share = from->front_share;
  to->areal_heat_capacity = from->areal_heat_capacity_J_m2_K;
  to->conductance = from->conductance_W_K;
  to->through_conductance =
      isnan(from->through_conductance_W_m2_K) ? INFINITY : from->through_conductance_W_m2_K;
  if (from->layers.count > 0) return um_model_build_layers(context, model, from, to);
  if (from->honeycomb != NULL) UM_TRY(um_model_build_honeycomb(context, model, from, to));
  if (from->material != NULL) {
    const struct um_materials_record *record =
        um_materials_library_find(model->library, from->material);
    struct um_materials_bulk bulk = um_materials_bulk(record);
    double thickness = isnan(from->thickness_mm) ? bulk.thickness : from->thickness_mm * 1e-3;
    if (isnan(to->areal_heat_capacity)) {
      to->areal_heat_capacity = isnan(from->thickness_mm) && !isnan(bulk.areal_heat_capacity)
                                    ? bulk.areal_heat_capacity
                                    : bulk.density * bulk.specific_heat * thickness;
      UM_TRY(um_model_bulk_ratio(context, model, record, UM_BULK_SPECIFIC_HEAT, &to->law.capacity));
    }
    if (isnan(to->conductance)) {
      to->conductance = bulk.conductivity * thickness;
      UM_TRY(
          um_model_bulk_ratio(context, model, record, UM_BULK_CONDUCTIVITY, &to->law.conductivity));
    }
    if (isnan(to->areal_heat_capacity))
      return um_document_mark_fail(context, &from->at,
                                   "material '%s' has no density, specific heat or thickness; give "
                                   "areal_heat_capacity_J_m2_K or thickness_mm",
                                   from->material);
  }
  if (isnan(to->conductance)) to->conductance = 0.0;
  if (isnan(to->areal_heat_capacity))
    return um_document_mark_fail(context, &from->at,
                                 "areal_heat_capacity_J_m2_K is missing; give it, or material and "
                                 "thickness_mm");
  return UM_OK;
}

/* A part that says nothing of its wall gets it from its materials as built. */
enum um_status um_model_build_shell_of_materials(struct um_context *context, struct um_model *model,
                                                 const struct um_scenario_part *part,
                                                 const struct um_geometry_group *group,
                                                 struct um_thermal_shell *to)
{
  *to = (struct um_thermal_shell){.front_share = 0.5, .through_conductance = INFINITY};
  const uint32_t side[2] = {group->front_material, group->back_material};
  for (int k = 0; k < 2; k++) {
    if (side[k] == UM_GEOMETRY_NONE || (k == 1 && side[1] == side[0])) continue;
    struct um_materials_bulk bulk = um_materials_bulk(model->material[side[k]]);
    if (isnan(bulk.areal_heat_capacity))
      return um_document_mark_fail(context, &part->at,
                                   "group '%s' has no wall: material '%s' has no thickness; give "
                                   "shell, solid, or mli that wraps the interior",
                                   group->name, um_materials_name(model->material[side[k]]));
    to->areal_heat_capacity += bulk.areal_heat_capacity;
    if (!isnan(bulk.conductivity) && !isnan(bulk.thickness))
      to->conductance += bulk.conductivity * bulk.thickness;
  }
  return UM_OK;
}

enum um_status um_model_build_solid(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_part *part,
                                    struct um_thermal_part_spec *to)
{
  const struct um_scenario_solid *from = part->solid;
  to->kind = UM_THERMAL_SOLID;
  to->density = from->density_kg_m3;
  to->specific_heat = from->specific_heat_J_kg_K;
  to->conductivity = from->conductivity_W_m_K;
  to->tetrahedron_size = from->tetrahedron_size_m;
  to->volume_power = from->power_W;
  UM_TRY(um_model_power_history(context, model, &from->at, from->power_file, &to->volume_history));
  if (from->material != NULL) {
    const struct um_materials_record *record =
        um_materials_library_find(model->library, from->material);
    struct um_materials_bulk bulk = um_materials_bulk(record);
    if (isnan(to->density)) to->density = bulk.density;
    if (isnan(to->specific_heat)) {
      to->specific_heat = bulk.specific_heat;
      UM_TRY(um_model_bulk_ratio(context, model, record, UM_BULK_SPECIFIC_HEAT, &to->law.capacity));
    }
    if (isnan(to->conductivity)) {
      to->conductivity = bulk.conductivity;
      UM_TRY(
          um_model_bulk_ratio(context, model, record, UM_BULK_CONDUCTIVITY, &to->law.conductivity));
    }
  }
  if (isnan(to->density) || isnan(to->specific_heat) || isnan(to->conductivity))
    return um_document_mark_fail(
        context, &from->at,
        "density, specific heat or conductivity is missing; give them or a "
        "material that has them");
  return UM_OK;
}

/* Is the name one of a blanket's outer layer: mli, mli_kapton, grey_mli? */
static bool is_blanket(const char *name)
{
  for (const char *at = name; (at = strstr(at, "mli")) != NULL; at += 3) {
    bool begins = at == name || at[-1] == '_' || at[-1] == '-';
    if (begins && (at[3] == '\0' || at[3] == '_' || at[3] == '-')) return true;
  }
  return false;
}

/* A blanket's outer layer on a wall without a blanket carries the wall's heat straight to space. */
void um_model_warn_of_bare_blanket(struct um_context *context, const struct um_model *model,
                                   const struct um_scenario_part *part,
                                   const struct um_thermal_group_spec *groups, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_group *group = um_geometry_group(model->geometry, groups[i].group);
    const struct um_scenario_group *own = um_model_group_named(part, group->name);
    if (group->front_material == UM_GEOMETRY_NONE) continue;
    const char *name = um_geometry_material_name(model->geometry, group->front_material);
    if (groups[i].mli != NULL || (own != NULL && own->bare) || !is_blanket(name)) continue;
    um_core_log(context, UM_LOG_WARNING,
                "%s:%d: parts.%s: '%s' is the outer layer of a blanket, but the part has no mli: "
                "its wall is as warm as its surface; accepted: mli: {effective_emittance: ...}, or "
                "groups with bare: true",
                part->at.file, part->at.line, part->name, name);
    return;
  }
}
