/* Walls of layers, each cut into cells of one thickness h:
 *
 *   front --h/k-- node --h/k-- node ... --h/k-- back
 *
 * A node has half of the cells on both of its sides, so that the wall is met to second order in h.
 */
#include "model/build/steps_impl.h"

#include <math.h>

#include "model/scenario/fail_group.h"

/* What a layer is made of, its own numbers before its record's. */
static enum um_status matter_of(struct um_context *context, const struct um_model *model,
                                const struct um_scenario_layer *layer,
                                struct um_materials_bulk *out)
{
  *out = (struct um_materials_bulk){.density = NAN, .specific_heat = NAN, .conductivity = NAN};
  if (layer->material != NULL)
    *out = um_materials_bulk(um_materials_library_find(model->library, layer->material));
  if (!isnan(layer->density_kg_m3)) out->density = layer->density_kg_m3;
  if (!isnan(layer->specific_heat_J_kg_K)) out->specific_heat = layer->specific_heat_J_kg_K;
  if (!isnan(layer->conductivity_W_m_K)) out->conductivity = layer->conductivity_W_m_K;
  if (!isnan(out->density) && !isnan(out->specific_heat) && !isnan(out->conductivity)) return UM_OK;
  return um_document_mark_fail(context, &layer->at,
                               "density, specific heat or conductivity is missing; accepted: them, "
                               "or a material that has them");
}

/* The layers say all of the wall but its conductance in plane. */
static enum um_status others_check(struct um_context *context,
                                   const struct um_scenario_shell *shell)
{
  const char *other = shell->material != NULL                     ? "material"
                      : shell->honeycomb != NULL                  ? "honeycomb"
                      : !isnan(shell->thickness_mm)               ? "thickness_mm"
                      : !isnan(shell->areal_heat_capacity_J_m2_K) ? "areal_heat_capacity_J_m2_K"
                      : !isnan(shell->through_conductance_W_m2_K) ? "through_conductance_W_m2_K"
                                                                  : NULL;
  if (other == NULL) return UM_OK;
  return um_model_fail(context, &shell->at, other, "excludes layers; accepted: one of the two");
}

enum um_status um_model_build_layers(struct um_context *context, struct um_model *model,
                                     const struct um_scenario_shell *shell,
                                     struct um_thermal_shell *to)
{
  const struct um_scenario_layer *layer = shell->layers.items;
  struct um_thermal_core *core = NULL;
  size_t cells = 0, node = 0;
  double capacity = 0.0, resistance = 0.0, plane = 0.0; /* [J/m^2/K], [m^2 K/W], [W/K] */
  double front = 0.0, half = 0.0;
  UM_TRY(others_check(context, shell));
  for (size_t i = 0; i < shell->layers.count; i++) cells += (size_t)layer[i].cells;
  UM_TRY(um_core_arena_allocate(context, &model->memory, 1, sizeof *core, &core));
  UM_TRY(um_core_arena_allocate(context, &model->memory, cells, sizeof *core->capacity,
                                &core->capacity));
  UM_TRY(um_core_arena_allocate(context, &model->memory, cells, sizeof *core->resistance,
                                &core->resistance));
  for (size_t i = 0; i < shell->layers.count; i++) {
    struct um_materials_bulk bulk;
    UM_TRY(matter_of(context, model, &layer[i], &bulk));
    double h = layer[i].thickness_mm * 1e-3 / layer[i].cells;
    double before = half; /* of the cell in front of the node */
    half = 0.5 * bulk.density * bulk.specific_heat * h;
    for (int k = 0; k < layer[i].cells; k++, node++) {
      if (node == 0)
        front = half;
      else
        core->capacity[node - 1] = k == 0 ? before + half : 2.0 * half;
      core->resistance[node] = h / bulk.conductivity;
      resistance += core->resistance[node];
      capacity += 2.0 * half;
      plane += bulk.conductivity * h;
    }
  }
  core->n = cells - 1;
  for (size_t k = 0; k < core->n; k++) core->capacity[k] /= capacity;
  for (size_t k = 0; k < cells; k++) core->resistance[k] /= resistance;
  to->areal_heat_capacity = capacity;
  to->front_share = front / capacity;
  to->through_conductance = 1.0 / resistance;
  if (isnan(to->conductance)) to->conductance = plane;
  to->core = core;
  return UM_OK;
}
