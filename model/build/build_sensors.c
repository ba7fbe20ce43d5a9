/* From the scenario's sensors to what they count of each bin of their band. */
#include <math.h>

#include "model/build/bands.h"
#include "model/build/messages_group.h"
#include "model/build/sensor_preset.h"
#include "model/build/steps_impl.h"
#include "optics/instrument/filter.h"

/* Mean of a curve over each bin of a band, multiplied into `to`. */
void um_model_bins_pass(const struct um_instrument_filter *curve, const struct um_optics_band *band,
                        double *to)
{
  for (int i = 0; i < band->bins; i++)
    to[i] *= um_instrument_filter_mean(curve, um_optics_band_edge(band, i),
                                       um_optics_band_edge(band, i + 1));
}

enum um_status um_model_bins_ones(struct um_context *context, struct um_model *model, int n,
                                  double **out)
{
  UM_TRY(um_core_arena_allocate(context, &model->memory, (size_t)n, sizeof **out, out));
  for (int i = 0; i < n; i++) (*out)[i] = 1.0;
  return UM_OK;
}

enum um_status um_model_curve_read(struct um_context *context, struct um_model *model,
                                   const struct um_mark *at, const char *key, const char *relative,
                                   struct um_instrument_filter **out)
{
  const char *path;
  *out = NULL;
  UM_TRY(um_model_resolve(context, model, at, relative, &path));
  return um_model_blame(context, at, key, um_instrument_filter_read(context, path, out));
}

static double or_else(double value, double other) { return isnan(value) ? other : value; }

static enum um_status build_efficiency(struct um_context *context, struct um_model *model,
                                       const struct um_scenario_sensor *from,
                                       struct um_model_sensor *to)
{
  const struct um_optics_band *band = &model->band[to->band];
  struct um_instrument_filter *curve;
  double level = from->throughput * or_else(from->quantum_efficiency, 1.0), most = 0.0;
  UM_TRY(um_model_bins_ones(context, model, band->bins, &to->efficiency));
  if (from->quantum_efficiency_file != NULL) {
    UM_TRY(um_model_curve_read(context, model, &from->at, "quantum_efficiency_file",
                               from->quantum_efficiency_file, &curve));
    um_model_bins_pass(curve, band, to->efficiency);
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
                                   const struct um_scenario_sensor *stated,
                                   struct um_model_sensor *to)
{
  struct um_scenario_sensor whole, *from = &whole;
  UM_TRY(um_model_sensor_preset(context, model, stated, &whole));
  if (!um_model_name_is_plain(from->name))
    return um_model_fail(context, &from->at, NULL,
                         "'%s' cannot name a sensor; accepted: a word without . / : , ; quotes and "
                         "control characters",
                         from->name);
  if (from->quantum_efficiency_file != NULL && !isnan(from->quantum_efficiency))
    return um_model_fail(context, &from->at, "quantum_efficiency",
                         "is given beside quantum_efficiency_file; accepted: one of them");
  if (isnan(from->aperture_m))
    return um_model_fail(context, &from->at, "aperture_m",
                         "is missing; accepted: it, or preset (`umbra list sensors` lists them)");
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

enum um_status um_model_build_sensors(struct um_context *context, struct um_model *model)
{
  const struct um_schema_list *list = &model->scenario->sensors;
  const struct um_scenario_sensor *from = list->items;
  UM_TRY(um_core_arena_allocate(context, &model->memory, list->count, sizeof *model->sensor,
                                &model->sensor));
  for (; model->nsensor < list->count; model->nsensor++)
    UM_TRY(build_sensor(context, model, &from[model->nsensor], &model->sensor[model->nsensor]));
  return UM_OK;
}
