/* From material records to how walls and solids store and conduct heat at temperatures: a table of
 * ratios for each record and property, made once for a model. */
#include "model/build/steps_impl.h"

static enum um_status ratio_make(struct um_context *context, struct um_model *model,
                                 const struct um_materials_record *record,
                                 enum um_materials_bulk_property property,
                                 const struct um_thermal_ratio **out)
{
  struct um_thermal_ratio *ratio = NULL;
  UM_TRY(um_core_arena_allocate(context, &model->memory, 1, sizeof *ratio, &ratio));
  for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
    ratio->at[k] = um_materials_bulk_ratio(record, property, (double)k * UM_THERMAL_LAW_STEP);
  *out = ratio;
  return UM_OK;
}

enum um_status um_model_bulk_ratio(struct um_context *context, struct um_model *model,
                                   const struct um_materials_record *record,
                                   enum um_materials_bulk_property property,
                                   const struct um_thermal_ratio **out)
{
  size_t n = um_materials_library_count(model->library), k = 0;
  *out = NULL;
  if (!model->environment.bulk_by_temperature || !um_materials_bulk_varies(record, property))
    return UM_OK;
  if (model->bulk_ratio == NULL)
    UM_TRY(um_core_arena_allocate(context, &model->memory, 2 * n, sizeof *model->bulk_ratio,
                                  &model->bulk_ratio));
  while (k < n && um_materials_library_at(model->library, k) != record) k++;
  const struct um_thermal_ratio **kept = &model->bulk_ratio[2 * k + (size_t)property];
  if (*kept == NULL) UM_TRY(ratio_make(context, model, record, property, kept));
  *out = *kept;
  return UM_OK;
}
