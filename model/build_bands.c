/* From the scenario's bands, filters and sensors to bins with what passes of each. */
#include "model/build_bands_impl.h"

#include <math.h>
#include <string.h>

#include "instrument/filter.h"
#include "model/bands.h"
#include "model/words_impl.h"

/* Mean of a curve over each bin of a band, multiplied into `to`. */
static void multiply(const struct um_instrument_filter *curve, const struct um_optics_band *band,
                     double *to)
{
  for (int i = 0; i < band->bins; i++)
    to[i] *= um_instrument_filter_mean(curve, um_optics_band_edge(band, i),
                                       um_optics_band_edge(band, i + 1));
}

static enum um_status ones(struct um_context *context, struct um_model *model, int n, double **out)
{
  UM_TRY(um_core_arena_allocate(context, &model->memory, (size_t)n, sizeof **out, out));
  for (int i = 0; i < n; i++) (*out)[i] = 1.0;
  return UM_OK;
}

static enum um_status read_curve(struct um_context *context, struct um_model *model,
                                 const struct um_mark *at, const char *key, const char *relative,
                                 struct um_instrument_filter **out)
{
  const char *path;
  *out = NULL;
  UM_TRY(um_model_resolve(context, model, at, relative, &path));
  return um_model_blame(context, at, key, um_instrument_filter_read(context, path, out));
}

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
    UM_TRY(read_curve(context, model, &from->at, "filter_file", from->filter_file, &filter));
  band->from = filter->wavelength[0];
  band->to = filter->wavelength[filter->n - 1];
  enum um_status status = ones(context, model, band->bins, &transmission);
  if (status == UM_OK) multiply(filter, band, transmission);
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

/* --- bins as photometry wants them ----------------------------------------------------------- */

static enum um_status bins_of(struct um_context *context, const struct um_optics_band *band,
                              const double *transmission, struct um_instrument_bins *out)
{
  double *wavelength, *width;
  size_t n = (size_t)band->bins;
  *out = (struct um_instrument_bins){.n = n, .transmission = transmission};
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *wavelength, &wavelength));
  width = wavelength + n;
  for (size_t i = 0; i < n; i++) {
    double from = um_optics_band_edge(band, (int)i), to = um_optics_band_edge(band, (int)i + 1);
    wavelength[i] = 0.5 * (from + to);
    width[i] = to - from;
  }
  out->wavelength = wavelength;
  out->width = width;
  return UM_OK;
}

static enum um_status build_vega(struct um_context *context, struct um_model *model, size_t b)
{
  const struct um_optics_band *band = &model->band[b];
  const struct um_scenario_band *from = model->scenario->bands.items;
  struct um_instrument_bins bins;
  UM_TRY(bins_of(context, band, band->transmission, &bins));
  model->vega_ab[b] = um_instrument_vega_ab(&bins);
  if (model->scenario->bands.count > 0) model->vega_ab[b] -= from[b].vega_magnitude;
  um_core_free(context, (void *)(uintptr_t)bins.wavelength);
  return UM_OK;
}

/* --- sensors --------------------------------------------------------------------------------- */

static double or_else(double value, double other) { return isnan(value) ? other : value; }

static enum um_status build_efficiency(struct um_context *context, struct um_model *model,
                                       const struct um_scenario_sensor *from,
                                       struct um_model_sensor *to)
{
  const struct um_optics_band *band = &model->band[to->band];
  struct um_instrument_filter *curve;
  double level = from->throughput * or_else(from->quantum_efficiency, 1.0), most = 0.0;
  UM_TRY(ones(context, model, band->bins, &to->efficiency));
  if (from->quantum_efficiency_file != NULL) {
    UM_TRY(read_curve(context, model, &from->at, "quantum_efficiency_file",
                      from->quantum_efficiency_file, &curve));
    multiply(curve, band, to->efficiency);
    um_instrument_filter_destroy(context, &curve);
  }
  for (int i = 0; i < band->bins; i++) {
    to->efficiency[i] *= level * (band->transmission != NULL ? band->transmission[i] : 1.0);
    most = fmax(most, to->efficiency[i]);
  }
  if (most > 0.0) return UM_OK;
  return um_model_fail(context, &from->at, "quantum_efficiency_file",
                       "counts nothing of band '%s'; accepted: a curve that reaches into %g to %g "
                       "um",
                       band->name, band->from * 1e6, band->to * 1e6);
}

static enum um_status build_sensor(struct um_context *context, struct um_model *model,
                                   const struct um_scenario_sensor *from,
                                   struct um_model_sensor *to)
{
  if (!um_model_name_is_plain(from->name))
    return um_model_fail(context, &from->at, NULL,
                         "'%s' cannot name a sensor; accepted: a word without . / : , ; quotes and "
                         "control characters",
                         from->name);
  if (from->quantum_efficiency_file != NULL && !isnan(from->quantum_efficiency))
    return um_model_fail(context, &from->at, "quantum_efficiency",
                         "is given beside quantum_efficiency_file; accepted: one of them");
  to->name = from->name;
  to->exposure = or_else(from->exposure_s, model->scenario->time->exposure_s);
  if (!isnan(from->pixel_arcsec) && !(to->exposure > 0.0))
    return um_model_fail(context, &from->at, "pixel_arcsec",
                         "noise is that of an exposure, whose length is not given; accepted: "
                         "exposure_s beside it, or time.exposure_s");
  UM_TRY(um_model_blame(context, &from->at, "band",
                        um_model_band_require(context, model, from->band, &to->band)));
  to->optics = (struct um_instrument_sensor){.aperture = from->aperture_m,
                                             .obstruction = from->obstruction,
                                             .gain = from->gain_e,
                                             .pixel = from->pixel_arcsec,
                                             .fwhm = from->fwhm_arcsec,
                                             .radius = from->radius_fwhm,
                                             .annulus = or_else(from->annulus_pixels, INFINITY),
                                             .read_noise = from->read_noise_e,
                                             .dark = from->dark_e_s,
                                             .sky = or_else(from->sky_mag_arcsec2, INFINITY),
                                             .emissivity = from->optics_emissivity,
                                             .temperature = from->optics_temperature_K,
                                             .saturation = or_else(from->saturation_e, INFINITY),
                                             .noise_equivalent_irradiance =
                                                 from->noise_equivalent_irradiance_W_m2};
  return build_efficiency(context, model, from, to);
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
  const struct um_schema_list *list = &model->scenario->bands, *counts = &model->scenario->sensors;
  const struct um_scenario_band *from = list->items;
  const struct um_scenario_sensor *sensor = counts->items;
  if (model->origin != NULL) {
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
  UM_TRY(um_core_arena_allocate(context, memory, counts->count, sizeof *model->sensor,
                                &model->sensor));
  for (; model->nsensor < counts->count; model->nsensor++)
    UM_TRY(build_sensor(context, model, &sensor[model->nsensor], &model->sensor[model->nsensor]));
  return UM_OK;
}
