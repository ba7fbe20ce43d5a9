/* What a record says of its numbers: over which wavelengths they are measured, and how the surface
 * is published to age. Neither changes its optics. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "materials/record_impl.h"
#include "materials/schema_impl.h"

/* Widen a range by that of a table [um]. */
static void widen(const struct um_schema_list *wavelength_um, double *from, double *to)
{
  const double *x = wavelength_um->items;
  if (wavelength_um->count == 0) return;
  *from = fmin(*from, x[0]);
  *to = fmax(*to, x[wavelength_um->count - 1]);
}

/* Wavelengths that any table of a record covers [um]; *from above *to where it has none. */
static void tables_range(const struct um_materials_input *in, double *from, double *to)
{
  const struct um_materials_constants_input *layer = in->layers.items;
  *from = INFINITY;
  *to = -INFINITY;
  if (in->reflectance != NULL) widen(&in->reflectance->wavelength_um, from, to);
  if (in->substrate != NULL) widen(&in->substrate->wavelength_um, from, to);
  if (in->sheet != NULL) widen(&in->sheet->wavelength_um, from, to);
  for (size_t i = 0; i < in->layers.count; i++) widen(&layer[i].wavelength_um, from, to);
}

static double solar_outside(const struct um_materials_sun *sun, double from, double to)
{
  double sum = 0.0;
  for (size_t i = 0; i < UM_MATERIALS_SUN; i++)
    if (sun->wavelength[i] < from || sun->wavelength[i] > to) sum += sun->share[i];
  return sum;
}

static double heat_outside(double from, double to)
{
  return 1.0 - um_core_planck_fraction(to * UM_REFERENCE_TEMPERATURE) +
         um_core_planck_fraction(from * UM_REFERENCE_TEMPERATURE);
}

static enum um_status range_read(struct um_context *context, const struct um_materials_sun *sun,
                                 const struct um_materials_input *in,
                                 struct um_materials_measured_range *out)
{
  const double *um = in->measured.items;
  double first, last;
  *out = (struct um_materials_measured_range){NAN, NAN, NAN, NAN};
  if (in->measured.count == 0) return UM_OK;
  if (in->measured.count != 2 || !(um[0] < um[1]))
    return um_document_mark_fail(context, &in->at,
                                 "measured_um is not a range; accepted: [from, to], ascending");
  tables_range(in, &first, &last);
  if (!(um[0] >= first && um[1] <= last))
    return um_document_mark_fail(
        context, &in->at, "measured_um is %g to %g; accepted: within the tables, %g to %g [um]",
        um[0], um[1], first, last);
  out->from = um[0] * 1e-6;
  out->to = um[1] * 1e-6;
  out->solar_outside = solar_outside(sun, out->from, out->to);
  out->heat_outside = heat_outside(out->from, out->to);
  return UM_OK;
}

static enum um_status ageing_read(struct um_context *context, const struct um_schema_list *list,
                                  struct um_materials_record *record)
{
  const struct um_materials_ageing_input *in = list->items;
  if (list->count == 0) return UM_OK;
  UM_TRY(um_core_allocate(context, list->count, sizeof *record->ageing, &record->ageing));
  for (size_t i = 0; i < list->count; i++) {
    char *after, *source;
    if (isnan(in[i].absorptance) && isnan(in[i].emittance))
      return um_document_mark_fail(context, &in[i].at,
                                   "says of no change; accepted: solar_absorptance_change, "
                                   "emittance_change or both");
    UM_TRY(um_core_strdup(context, in[i].after, &after));
    record->ageing[i] =
        (struct um_materials_ageing){after, in[i].absorptance, in[i].emittance, NULL};
    record->nageing++;
    UM_TRY(um_core_strdup(context, in[i].source, &source));
    record->ageing[i].source = source;
  }
  return UM_OK;
}

enum um_status um_materials_published_read(struct um_context *context,
                                           const struct um_materials_sun *sun,
                                           const struct um_materials_input *in,
                                           struct um_materials_record *record)
{
  UM_TRY(range_read(context, sun, in, &record->measured_range));
  return ageing_read(context, &in->ageing, record);
}

void um_materials_published_free(struct um_materials_record *record)
{
  for (size_t i = 0; i < record->nageing; i++)
    UM_FREE(record->context, (char *)record->ageing[i].after, (char *)record->ageing[i].source);
  um_core_free(record->context, record->ageing);
}

struct um_materials_measured_range
um_materials_measured_range(const struct um_materials_record *record)
{
  return record->measured_range;
}

size_t um_materials_ageing_count(const struct um_materials_record *record)
{
  return record->nageing;
}

struct um_materials_ageing um_materials_ageing_at(const struct um_materials_record *record,
                                                  size_t index)
{
  return record->ageing[index];
}
