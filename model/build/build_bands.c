/* From the scenario's bands and filters to bins with what passes of each. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "model/build/bands.h"
#include "model/scenario/fail_group.h"
#include "optics/instrument/filter.h"

/* --- bands ----------------------------------------------------------------------------------- */

static enum um_status through_filter(struct um_context *context, struct um_model *model,
                                     const struct um_scenario_band *from,
                                     struct um_optics_band *band)
{
  struct um_instrument_filter *filter;
  double *transmission;
  if (from->filter != NULL)
    UM_TRY(um_model_blame(context, &from->at, "filter",
                          um_instrument_filter_find(context, from->filter, &filter)));
  else
    UM_TRY(
        um_model_curve_read(context, model, &from->at, "filter_file", from->filter_file, &filter));
  band->from = filter->wavelength[0];
  band->to = filter->wavelength[filter->n - 1];
  enum um_status status = um_model_bins_ones(context, model, band->bins, &transmission);
  if (status == UM_OK) um_model_bins_pass(filter, band, transmission);
  band->transmission = transmission;
  um_instrument_filter_destroy(context, &filter);
  return status;
}

static enum um_status build_band(struct um_context *context, struct um_model *model,
                                 const struct um_scenario_band *from, struct um_optics_band *band)
{
  int filters = (from->filter != NULL) + (from->filter_file != NULL);
  bool edges = !isnan(from->from_um) || !isnan(from->to_um);
  if (!um_model_name_is_plain(from->name))
    return um_model_fail(context, &from->at, NULL,
                         "'%s' cannot name a band; accepted: a word without . / : , ; quotes and "
                         "control characters",
                         from->name);
  *band = (struct um_optics_band){.name = from->name, .bins = from->bins};
  if (filters + edges != 1)
    return um_model_fail(
        context, &from->at, NULL, "%s; accepted: from_um with to_um, or filter, or filter_file",
        filters + edges == 0 ? "no edges and no filter" : "its edges are given twice");
  if (filters == 1) return through_filter(context, model, from, band);
  if (isnan(from->from_um) || isnan(from->to_um))
    return um_model_fail(context, &from->at, NULL, "one edge is missing; accepted: %s as well",
                         isnan(from->from_um) ? "from_um" : "to_um");
  if (!(from->from_um < from->to_um))
    return um_model_fail(context, &from->at, "to_um",
                         "%g is not above from_um %g; accepted: more than that", from->to_um,
                         from->from_um);
  band->from = from->from_um * 1e-6;
  band->to = from->to_um * 1e-6;
  return UM_OK;
}

/* --- magnitudes ------------------------------------------------------------------------------ */

static enum um_status build_vega(struct um_context *context, struct um_model *model, size_t b)
{
  const struct um_scenario_band *from = model->scenario->bands.items;
  struct um_instrument_bins bins;
  UM_TRY(um_model_band_bins(context, &model->band[b], &bins));
  model->vega_ab[b] = um_instrument_vega_ab(&bins);
  if (model->scenario->bands.count > 0) model->vega_ab[b] -= from[b].vega_magnitude;
  um_model_band_bins_clear(context, &bins);
  return UM_OK;
}

/* Air that the scenario states must be known where its bands are. */
static enum um_status check_air(struct um_context *context, const struct um_model *model)
{
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  for (size_t b = 0; sky->present && b < model->nband; b++)
    if (!um_environment_clear_sky_covers(sky, model->band[b].from, model->band[b].to))
      return um_model_fail(
          context, &model->scenario->observer->air->at, sky->table != NULL ? "file" : NULL,
          "band '%s', %g to %g um, is beyond the air that is known; accepted: bands "
          "within %s",
          model->band[b].name, model->band[b].from * 1e6, model->band[b].to * 1e6,
          sky->table != NULL ? "the file's wavelengths"
                             : "0.3 to 1.16 um or 7.02 to 14.28 um, or a file");
  return UM_OK;
}

/* --- all ------------------------------------------------------------------------------------- */

enum um_status um_model_build_bands(struct um_context *context, struct um_model *model)
{
  static const struct um_optics_band standard[2] = {{"vis", 0.38e-6, 0.78e-6, 80, NULL},
                                                    {"lwir", 8e-6, 12e-6, 40, NULL}};
  static const char *const said[] = {"bands", "sensors", "observer.air", "time.exposure_s", NULL};
  const struct um_schema_list *list = &model->scenario->bands;
  const struct um_scenario_band *from = list->items;
  if (um_model_origin_says(model, said)) {
    model->band = model->origin->band;
    model->vega_ab = model->origin->vega_ab;
    model->sensor = model->origin->sensor;
    model->nband = model->origin->nband;
    model->nsensor = model->origin->nsensor;
    return UM_OK;
  }
  model->nband = list->count > 0 ? list->count : 2;
  struct um_core_arena *memory = &model->memory;
  UM_TRY(um_core_arena_allocate(context, memory, model->nband, sizeof *model->band, &model->band));
  UM_TRY(um_core_arena_allocate(context, memory, model->nband, sizeof(double), &model->vega_ab));
  if (list->count == 0) memcpy(model->band, standard, sizeof standard);
  for (size_t i = 0; i < list->count; i++)
    UM_TRY(build_band(context, model, &from[i], &model->band[i]));
  for (size_t b = 0; b < model->nband; b++) UM_TRY(build_vega(context, model, b));
  UM_TRY(check_air(context, model));
  return um_model_build_sensors(context, model);
}
