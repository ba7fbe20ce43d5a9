/* Blankets of MLI from their keys. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "model/scenario/fail_group.h"

/* A key that another law has. */
static enum um_status key_check(struct um_context *context, const struct um_scenario_mli *from,
                                const char *key, double value, bool wanted, bool allowed)
{
  static const char *const law[] = {"constant", "doenecke", "lockheed"};
  if (isnan(value) && wanted)
    return um_model_fail(context, &from->at, key, "is missing; law: %s needs it", law[from->law]);
  if (!isnan(value) && !allowed)
    return um_model_fail(context, &from->at, key, "is not of law: %s; accepted: without it",
                         law[from->law]);
  return UM_OK;
}

static enum um_status keys_check(struct um_context *context, const struct um_scenario_mli *from)
{
  bool constant = from->law == UM_MLI_CONSTANT, lockheed = from->law == UM_MLI_LOCKHEED;
  UM_TRY(key_check(context, from, "effective_emittance", from->effective_emittance, constant,
                   constant));
  UM_TRY(key_check(context, from, "factor", from->factor, false, from->law == UM_MLI_DOENECKE));
  UM_TRY(key_check(context, from, "layers", from->layers, lockheed, lockheed));
  UM_TRY(key_check(context, from, "layers_per_cm", from->layers_per_cm, lockheed, lockheed));
  UM_TRY(key_check(context, from, "shield_emittance", from->shield_emittance, false, lockheed));
  if (isnan(from->seam_length_m) != isnan(from->seam_conductance_W_m_K))
    return um_model_fail(context, &from->at,
                         isnan(from->seam_length_m) ? "seam_conductance_W_m_K" : "seam_length_m",
                         "stands alone; accepted: seam_length_m and seam_conductance_W_m_K");
  bool stated = !isnan(from->sheets_areal_heat_capacity_J_m2_K);
  if (stated != (from->sheets > 0))
    return um_model_fail(context, &from->at,
                         stated ? "sheets_areal_heat_capacity_J_m2_K" : "sheets",
                         "stands alone; accepted: sheets and sheets_areal_heat_capacity_J_m2_K");
  return UM_OK;
}

enum um_status um_model_build_mli(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_part *part,
                                  const struct um_scenario_mli *from, double area,
                                  struct um_thermal_mli **out)
{
  struct um_thermal_mli *mli = NULL;
  bool inside = from->wraps != NULL && strcmp(from->wraps, "wall") != 0;
  size_t interior = inside ? um_model_interior_find(part, from->wraps) : 0;
  if (interior == UM_MODEL_NO_INTERIOR && strcmp(from->wraps, "interior") == 0)
    return um_document_mark_fail(
        context, &from->at, "wraps the interior, but the part '%s' has no interior", part->name);
  if (interior == UM_MODEL_NO_INTERIOR)
    return um_model_refuse_interior(context, part, &from->at, "wraps", from->wraps, "wall");
  UM_TRY(keys_check(context, from));
  UM_TRY(um_core_arena_allocate(context, &model->memory, 1, sizeof *mli, &mli));
  struct um_thermal_mli_slope slope = {from->effective_emittance, 0.0};
  if (from->law == UM_MLI_DOENECKE)
    slope = um_thermal_mli_doenecke(isnan(from->factor) ? 1.0 : from->factor);
  else if (from->law == UM_MLI_LOCKHEED)
    slope = um_thermal_mli_lockheed(from->layers, from->layers_per_cm * 100.0,
                                    isnan(from->shield_emittance) ? 0.031 : from->shield_emittance);
  if (!(slope.effective_emittance <= 1.0))
    return um_model_fail(context, &from->at, "law",
                         "makes the effective emittance at 300 K %g; accepted: up to 1",
                         slope.effective_emittance);
  mli->effective_emittance = slope.effective_emittance;
  mli->conducted = slope.conducted;
  mli->law = (enum um_thermal_mli_law)from->law;
  mli->areal_heat_capacity = from->areal_heat_capacity_J_m2_K;
  mli->sheets = (size_t)from->sheets;
  if (from->sheets > 0) mli->sheet_heat_capacity = from->sheets_areal_heat_capacity_J_m2_K;
  mli->wraps_interior = inside;
  mli->interior = interior;
  if (!isnan(from->seam_length_m))
    mli->seam_conductance = from->seam_length_m * from->seam_conductance_W_m_K / area;
  *out = mli;
  return UM_OK;
}
