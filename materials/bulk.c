/* Bulk properties of a record: density, heat capacity, conductivity, and how the latter two go with
 * temperature (tables, linear between rows, constant beyond). */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

static double table_at(const struct um_materials_table *table, double temperature)
{
  const double *t = table->temperature;
  size_t n = table->n;
  if (temperature <= t[0]) return table->value[0];
  if (temperature >= t[n - 1]) return table->value[n - 1];
  size_t k = 1;
  while (t[k] < temperature) k++;
  double u = (temperature - t[k - 1]) / (t[k] - t[k - 1]);
  return (1.0 - u) * table->value[k - 1] + u * table->value[k];
}

static enum um_status table_read(struct um_context *context,
                                 const struct um_materials_by_temperature_input *in,
                                 const char *key, const struct um_schema_list *list,
                                 struct um_materials_table *out)
{
  const double *t = in->temperature.items;
  if (list->count == 0) return UM_OK;
  if (list->count != in->temperature.count)
    return um_document_mark_fail(context, &in->at,
                                 "%s has %zu values; accepted: %zu, one per temperature_K", key,
                                 list->count, in->temperature.count);
  UM_TRY(um_core_allocate(context, list->count, sizeof(double), &out->temperature));
  UM_TRY(um_core_allocate(context, list->count, sizeof(double), &out->value));
  memcpy(out->temperature, t, list->count * sizeof(double));
  memcpy(out->value, list->items, list->count * sizeof(double));
  out->n = list->count;
  return UM_OK;
}

static enum um_status tables_read(struct um_context *context,
                                  const struct um_materials_by_temperature_input *in,
                                  struct um_materials_record *record)
{
  const double *t = in->temperature.items;
  if (in->temperature.count < 2)
    return um_document_mark_fail(context, &in->at,
                                 "temperature_K has %zu values; accepted: at least 2, ascending",
                                 in->temperature.count);
  for (size_t k = 1; k < in->temperature.count; k++)
    if (!(t[k] > t[k - 1]))
      return um_document_mark_fail(context, &in->at,
                                   "temperature_K: %g follows %g [K]; accepted: ascending values",
                                   t[k], t[k - 1]);
  if (in->specific_heat.count + in->conductivity.count == 0)
    return um_document_mark_fail(context, &in->at,
                                 "says nothing of the temperatures it has; accepted: "
                                 "specific_heat_J_kg_K, conductivity_W_m_K or both");
  UM_TRY(
      table_read(context, in, "specific_heat_J_kg_K", &in->specific_heat, &record->specific_heat));
  return table_read(context, in, "conductivity_W_m_K", &in->conductivity, &record->conductivity);
}

enum um_status um_materials_bulk_read(struct um_context *context,
                                      const struct um_materials_thermal_input *in,
                                      struct um_materials_record *record)
{
  struct um_materials_bulk *out = &record->bulk;
  *out = (struct um_materials_bulk){NAN, NAN, NAN, NAN, NAN, NAN, NAN};
  if (in == NULL) return UM_OK;
  out->density = in->density;
  out->specific_heat = in->specific_heat;
  out->conductivity = in->conductivity;
  out->thickness = in->thickness_mm * 1e-3;
  out->areal_heat_capacity = !isnan(in->areal_heat_capacity)
                                 ? in->areal_heat_capacity
                                 : in->density * in->specific_heat * out->thickness;
  const double *range = in->range.items;
  if (in->range.count != 0 && (in->range.count != 2 || !(range[0] < range[1])))
    return um_document_mark_fail(context, &in->at,
                                 "temperature_range_K has not two ascending values; accepted: "
                                 "[coldest, hottest]");
  if (in->range.count == 2) {
    out->coldest = range[0];
    out->hottest = range[1];
  }
  return in->by_temperature == NULL ? UM_OK : tables_read(context, in->by_temperature, record);
}

void um_materials_bulk_free(struct um_materials_record *record)
{
  struct um_materials_table *table[2] = {&record->specific_heat, &record->conductivity};
  for (int k = 0; k < 2; k++) {
    UM_FREE(record->context, table[k]->temperature, table[k]->value);
  }
}

struct um_materials_bulk um_materials_bulk(const struct um_materials_record *record)
{
  return record->bulk;
}

bool um_materials_bulk_varies(const struct um_materials_record *record,
                              enum um_materials_bulk_property property)
{
  return property == UM_BULK_SPECIFIC_HEAT ? record->specific_heat.n > 0
                                           : record->conductivity.n > 0;
}

double um_materials_bulk_ratio(const struct um_materials_record *record,
                               enum um_materials_bulk_property property, double temperature)
{
  const struct um_materials_table *table =
      property == UM_BULK_SPECIFIC_HEAT ? &record->specific_heat : &record->conductivity;
  if (table->n == 0) return 1.0;
  return table_at(table, temperature) / table_at(table, UM_REFERENCE_TEMPERATURE);
}
