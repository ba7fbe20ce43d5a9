/* Light curves of the geometry tables: intensities from the renderer, irradiance at the
 * aperture, magnitudes without an atmosphere. */
#include <math.h>
#include <string.h>

#include "environment/airmass.h"
#include "model/build/aging_group.h"
#include "model/build/effects_group.h"
#include "model/run/counts.h"
#include "model/run/effect_view.h"
#include "model/run/grey_body.h"
#include "model/run/parts_impl.h"
#include "model/run/run_optics_group.h"

int um_model_paths(const struct um_model *model, const struct um_model_tables *tables)
{
  int stated = tables->sampling.paths;
  if (stated == 0) stated = model->scenario->optics->interreflection_samples;
  if (!model->environment.inter_reflection_on) return 0;
  return stated > 0 ? stated : UM_SCENARIO_PATHS; /* 0: switched on by hand */
}

enum um_status um_model_scene_make(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables, const double *surface,
                                   struct um_optics_scene *out)
{
  size_t n = tables->nobs * tables->nsub, nsurface = tables->seen->nsurface;
  const float *brightness_from = tables->seen->brightness;
  float *albedo = NULL, *view_factor = NULL, *brightness = NULL;
  struct um_materials_adjustment *adjustment = NULL;
  enum um_status status;
  UM_CHECK(um_model_materials_over(context, model, tables->sample, n, &adjustment));
  UM_CHECK(um_core_allocate(context, n * nsurface, sizeof *albedo, &albedo));
  UM_CHECK(um_core_allocate(context, n * nsurface, sizeof *view_factor, &view_factor));
  if (brightness_from != NULL)
    UM_CHECK(um_core_allocate(context, n * nsurface, sizeof *brightness, &brightness));
  for (size_t i = 0; i < n; i++) {
    size_t row = tables->load_row[i] * nsurface;
    if (brightness != NULL)
      memcpy(brightness + i * nsurface, brightness_from + row, nsurface * sizeof *brightness);
    memcpy(albedo + i * nsurface, tables->seen->albedo + row, nsurface * sizeof *albedo);
    memcpy(view_factor + i * nsurface, tables->seen->view_factor + row,
           nsurface * sizeof *view_factor);
  }
  *out = (struct um_optics_scene){.geometry = model->geometry,
                                  .creases = model->creases,
                                  .environment = &model->environment,
                                  .samples = tables->sample,
                                  .view = tables->view,
                                  .material = model->material,
                                  .adjustment = adjustment != NULL ? adjustment : model->adjustment,
                                  .ages = adjustment != NULL,
                                  .temperature = surface,
                                  .albedo = albedo,
                                  .view_factor = view_factor,
                                  .brightness = brightness,
                                  .interreflection_samples = um_model_paths(model, tables),
                                  .photons = tables->photons};
  return UM_OK;
done:
  UM_FREE(context, adjustment, albedo, view_factor, brightness);
  return status;
}

void um_model_scene_release(struct um_context *context, struct um_optics_scene *scene)
{
  if (scene->ages) um_core_free(context, (void *)(uintptr_t)scene->adjustment);
  UM_FREE(context, (void *)(uintptr_t)scene->albedo, (void *)(uintptr_t)scene->view_factor,
          (void *)(uintptr_t)scene->brightness);
  scene->albedo = scene->view_factor = scene->brightness = NULL;
}

static enum um_status result_arrays(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables,
                                    const struct um_optics_lightcurve *curve,
                                    struct um_model_result *r)
{
  size_t n = tables->nobs;
  r->nband = curve->nband;
  r->nsensor = model->nsensor;
  r->nbin = curve->nbin;
  r->nmaterial = curve->nmaterial;
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->irradiance));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->magnitude_ab));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->measured_intensity));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->standard_error));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->irradiance_error));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->magnitude_error));
  UM_TRY(um_core_allocate(context, n * r->nband * r->nmaterial * UM_MECHANISM_COUNT, sizeof(double),
                          &r->intensity));
  UM_TRY(um_core_allocate(context, n * r->nbin * UM_MECHANISM_COUNT, sizeof(double), &r->spectral));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(double), &r->wavelength));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(double), &r->bin_width));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(double), &r->transmission));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(uint32_t), &r->bin_band));
  UM_TRY(um_core_allocate(context, r->nband, sizeof(double), &r->vega_ab));
  UM_TRY(um_core_allocate(context, n * r->nsensor, sizeof(double), &r->count_rate));
  UM_TRY(um_core_allocate(context, n * r->nsensor, sizeof(double), &r->count_rate_error));
  memcpy(r->vega_ab, model->vega_ab, r->nband * sizeof(double));
  memcpy(r->transmission, curve->transmission, r->nbin * sizeof(double));
  memcpy(r->wavelength, curve->wavelength, r->nbin * sizeof(double));
  memcpy(r->bin_width, curve->width, r->nbin * sizeof(double));
  memcpy(r->bin_band, curve->band, r->nbin * sizeof(uint32_t));
  return UM_OK;
}

/* Spectral irradiance of one observation, both [nbin] [W/m^2/m]. */
struct spectral_irradiance {
  double *exo_atmospheric, *at_aperture;
};

/* Numbers of one observation: magnitudes of what is above the atmosphere, the rest of what comes
 * through. */
static void photometry(const struct um_model *model, const struct um_model_tables *tables, size_t k,
                       const struct spectral_irradiance *light, struct um_model_result *r)
{
  bool hidden = tables->hidden[k];
  for (size_t b = 0; b < r->nband; b++) {
    struct um_instrument_bins bins = um_model_bins(r, b, NULL);
    size_t first = (size_t)(bins.wavelength - r->wavelength), at = k * r->nband + b;
    double above = um_instrument_irradiance(&bins, light->exo_atmospheric + first);
    double below = um_instrument_irradiance(&bins, light->at_aperture + first);
    double magnitude = um_instrument_magnitude_ab(&bins, light->exo_atmospheric + first);
    r->irradiance[at] = hidden ? (double)NAN : below;
    r->magnitude_ab[at] = hidden ? (double)NAN : magnitude;
    if (below != above) r->irradiance_error[at] *= below / above;
    if (hidden) r->irradiance_error[at] = NAN;
  }
  for (size_t s = 0; s < r->nsensor; s++) {
    const struct um_model_sensor *sensor = &model->sensor[s];
    struct um_instrument_bins bins = um_model_bins(r, sensor->band, sensor->efficiency);
    const double *spectral = light->at_aperture + (bins.wavelength - r->wavelength);
    r->count_rate[k * r->nsensor + s] =
        hidden ? (double)NAN : um_instrument_count_rate(&sensor->optics, &bins, spectral);
  }
}

/* What the air above the station lets through of a bin [1]; airmass NaN: no air on the way. */
static double transmission(const struct um_environment_clear_sky *sky,
                           const struct um_model_result *r, size_t bin, double airmass)
{
  double half = 0.5 * r->bin_width[bin];
  if (isnan(airmass)) return 1.0;
  return um_environment_clear_sky_transmission(sky, r->wavelength[bin] - half,
                                               r->wavelength[bin] + half, airmass);
}

/* Means over the exposure; E = I / R^2 instant by instant. Standard errors of the instants share
 * their sample points, so they are averaged, not reduced. */
static enum um_status average(struct um_context *context, const struct um_model *model,
                              const struct um_model_tables *tables,
                              const struct um_optics_lightcurve *curve, struct um_model_result *r,
                              const struct spectral_irradiance *light)
{
  size_t per_time = r->nband * r->nmaterial * UM_MECHANISM_COUNT;
  size_t per_spectrum = r->nbin * UM_MECHANISM_COUNT;
  double w = 1.0 / (double)tables->nsub;
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  for (size_t k = 0; k < tables->nobs; k++) {
    UM_TRY(um_core_stop_check(context, "light was averaged"));
    memset(light->exo_atmospheric, 0, r->nbin * sizeof(double));
    memset(light->at_aperture, 0, r->nbin * sizeof(double));
    for (size_t i = k * tables->nsub; i < (k + 1) * tables->nsub; i++) {
      double range = tables->sample[i].range;
      double airmass =
          sky->on ? um_environment_airmass_toward(tables->look[i].elevation) : (double)NAN;
      for (size_t j = 0; j < per_time; j++)
        r->intensity[k * per_time + j] += w * curve->intensity[i * per_time + j];
      for (size_t bin = 0; bin < r->nbin; bin++) {
        double passed = transmission(sky, r, bin, airmass);
        for (size_t m = 0; m < UM_MECHANISM_COUNT; m++) {
          size_t j = bin * UM_MECHANISM_COUNT + m;
          double value = curve->spectral[i * per_spectrum + j];
          double irradiance = w * value / (range * range);
          r->spectral[k * per_spectrum + j] += w * value;
          light->exo_atmospheric[bin] += irradiance;
          light->at_aperture[bin] += passed * irradiance;
        }
      }
      for (size_t b = 0; b < r->nband; b++) {
        double error = w * curve->stderr_[i * r->nband + b];
        r->standard_error[k * r->nband + b] += error;
        r->irradiance_error[k * r->nband + b] += error / (range * range);
      }
    }
    photometry(model, tables, k, light, r);
  }
  return UM_OK;
}

/* Band irradiance of a source of magnitude 0 that is the same at every wavelength [W/m^2].
 * flat: [nbin] of ones [W/m^2/m]. */
static double irradiance_of_zero(const struct um_model_result *r, size_t b, const double *flat)
{
  struct um_instrument_bins bins = um_model_bins(r, b, NULL);
  return um_instrument_irradiance(&bins, flat) *
         pow(10.0, 0.4 * um_instrument_magnitude_ab(&bins, flat));
}

/* What is measured at an observation, for effects that act on it. */
struct reading {
  size_t k, b;
  double zero; /* irradiance of AB magnitude 0 [W/m^2] */
  bool exo_atmospheric;
  const struct um_instrument_sensor *sensor; /* NULL: no counts */
  double electrons, background;              /* of um_effect_observation */
  const double *sky;                         /* [nobs][nband] likewise; NULL: nobody asks */
  const struct um_model_result *result;      /* its light by material is that before effects */
  const char *const *material;               /* [nmaterial] */
};

static double sky_of(const struct um_model *model, const struct reading *reading)
{
  return reading->sky != NULL ? reading->sky[reading->k * model->nband + reading->b] : 0.0;
}

/* One reading through all effects: what comes to the aperture, or, as if there were no atmosphere,
 * what the magnitude is made of. Switches stand for the detector and act on what the others leave.
 */
static enum um_status transform(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables, const struct reading *reading,
                                double *value)
{
  size_t middle = reading->k * tables->nsub + tables->nsub / 2;
  double elevation = tables->look[middle].elevation;
  const struct um_effect_view view =
      um_model_effect_view(tables, reading->result, reading->material, reading->k, reading->b);
  struct um_effect_observation o = {.t_tai = tables->t_obs[reading->k],
                                    .elevation = elevation,
                                    .airmass = um_environment_airmass_toward(elevation),
                                    .band = model->band[reading->b].name,
                                    .exo_atmospheric = reading->exo_atmospheric,
                                    .zero = reading->zero,
                                    .sky = sky_of(model, reading),
                                    .sensor = reading->sensor,
                                    .electrons = reading->electrons,
                                    .background = reading->background,
                                    .view = &view};
  return um_model_observe(context, model, tables->set != NULL ? tables->set[reading->k] : NULL, &o,
                          value);
}

enum um_status um_model_observe(struct um_context *context, const struct um_model *model,
                                const char *set, const struct um_effect_observation *at,
                                double *value)
{
  struct um_effect_use use;
  for (int detector = 0; detector < 2; detector++)
    for (size_t i = 0; um_model_effect_next_in(model, set, &i, &use);) {
      struct um_effect_observation seen = *at;
      if (use.effect->hooks.observation == NULL || use.effect->on_by_default != detector) continue;
      seen.value = *value;
      UM_TRY(use.effect->hooks.observation(context, &use, &seen));
      *value = seen.value;
    }
  return UM_OK;
}

/* A radiant intensity is measured as irradiance, without an atmosphere, and taken back by R^2. */
static enum um_status observe_intensity(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        const struct reading *reading, struct um_model_result *r)
{
  size_t k = reading->k, b = reading->b;
  double range = tables->sample[k * tables->nsub + tables->nsub / 2].range;
  double intensity = um_model_result_intensity(r, k, b, -1), e = intensity / (range * range);
  double after = e;
  UM_TRY(transform(context, model, tables, reading, &after));
  if (after != e) intensity = after * range * range;
  r->measured_intensity[k * r->nband + b] = intensity;
  return UM_OK;
}

/* How far the transform moves a value that moves by `error`: right for what is added, scaled or
 * bent (dead time) by effects. */
static enum um_status transform_error(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables,
                                      const struct reading *reading, double before, double after,
                                      double *error)
{
  double moved = before + *error;
  if (!(*error > 0.0)) return UM_OK;
  UM_TRY(transform(context, model, tables, reading, &moved));
  *error = fabs(moved - after);
  return UM_OK;
}

/* What effects do to an irradiance on its way to the number that is measured, and to the magnitude:
 * as irradiance, E_0 10^(-0.4 m), and back, so that what is added has no colour of its own. Errors
 * go the same way; that of the light has the light's own colour. */
static enum um_status observe(struct um_context *context, const struct um_model *model,
                              const struct um_model_tables *tables, struct um_model_result *r,
                              const double *flat, const double *sky, const char *const *material)
{
  for (size_t b = 0; b < r->nband; b++) {
    double zero = irradiance_of_zero(r, b, flat);
    for (size_t k = 0; k < r->nobs; k++) {
      size_t at = k * r->nband + b;
      double *magnitude = &r->magnitude_ab[at], *error = &r->irradiance_error[at];
      double before = zero * pow(10.0, -0.4 * *magnitude), after = before;
      double bare = r->irradiance[at], exo_error = *error * (bare > 0.0 ? before / bare : 1.0);
      struct reading here = {k, b, zero, false, NULL, NAN, NAN, sky, r, material}, above = here;
      above.exo_atmospheric = true;
      UM_TRY(transform(context, model, tables, &here, &r->irradiance[at]));
      UM_TRY(transform_error(context, model, tables, &here, bare, r->irradiance[at], error));
      UM_TRY(transform(context, model, tables, &above, &after));
      UM_TRY(transform_error(context, model, tables, &above, before, after, &exo_error));
      r->magnitude_error[at] = exo_error / zero;
      if (after != before) *magnitude = -2.5 * log10(after / zero);
      UM_TRY(observe_intensity(context, model, tables, &above, r));
    }
  }
  return UM_OK;
}

/* Counts likewise, as the irradiance that would be counted so if it were the same at every
 * wavelength. bare_error: relative, of the irradiance before effects [nobs][nband]. */
static enum um_status observe_counts(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables, const double *bare_error,
                                     const double *flat, const double *sky,
                                     const char *const *material, struct um_model_result *r)
{
  for (size_t s = 0; s < r->nsensor; s++) {
    const struct um_model_sensor *sensor = &model->sensor[s];
    struct um_instrument_bins all = um_model_bins(r, sensor->band, sensor->efficiency);
    struct um_instrument_bins passed = um_model_bins(r, sensor->band, NULL);
    double unit = um_instrument_count_rate(&sensor->optics, &all, flat) /
                  um_instrument_irradiance(&passed, flat); /* [1/s per W/m^2] */
    struct reading reading = {0,
                              sensor->band,
                              irradiance_of_zero(r, sensor->band, flat),
                              false,
                              &sensor->optics,
                              unit * sensor->optics.gain * sensor->exposure,
                              NAN,
                              sky,
                              r,
                              material};
    for (size_t k = 0; k < r->nobs; k++) {
      double *rate = &r->count_rate[k * r->nsensor + s], before = *rate / unit, after = before;
      double error = bare_error[k * r->nband + sensor->band] * before;
      reading.k = k;
      if (isfinite(sensor->optics.saturation)) /* the one that asks */
        reading.background = um_model_pixel_background(model, tables, r, k, s);
      UM_TRY(transform(context, model, tables, &reading, &after));
      UM_TRY(transform_error(context, model, tables, &reading, before, after, &error));
      if (after != before) *rate = after * unit;
      r->count_rate_error[k * r->nsensor + s] = error * unit;
    }
  }
  return UM_OK;
}

/* Light after effects; scratch: [nbin]. */
static enum um_status observe_all(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables, struct um_model_result *r,
                                  double *scratch)
{
  enum um_status status;
  double *bare_error = NULL, *sky = NULL;
  const char **material = NULL;
  size_t n = r->nobs * r->nband;
  UM_CHECK(um_model_material_names(context, model, &material));
  UM_CHECK(um_core_allocate(context, n, sizeof *bare_error, &bare_error));
  UM_CHECK(um_model_sky_bands(context, model, tables, r, &sky));
  for (size_t i = 0; i < n; i++)
    bare_error[i] = r->irradiance[i] > 0.0 ? r->irradiance_error[i] / r->irradiance[i] : 0.0;
  for (size_t i = 0; i < r->nbin; i++) scratch[i] = 1.0;
  UM_CHECK(observe(context, model, tables, r, scratch, sky, material));
  UM_CHECK(observe_counts(context, model, tables, bare_error, scratch, sky, material, r));
done:
  UM_FREE(context, bare_error, sky, (void *)material);
  return status;
}

enum um_status um_model_run_optics(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_optics_lightcurve *curve,
                                   struct um_model_result *result)
{
  enum um_status status;
  struct spectral_irradiance light = {NULL, NULL};
  if (curve == NULL) return UM_OK;
  UM_CHECK(result_arrays(context, model, tables, curve, result));
  UM_CHECK(um_core_allocate(context, curve->nbin, sizeof(double), &light.exo_atmospheric));
  UM_CHECK(um_core_allocate(context, curve->nbin, sizeof(double), &light.at_aperture));
  UM_CHECK(average(context, model, tables, curve, result, &light));
  UM_CHECK(observe_all(context, model, tables, result, light.exo_atmospheric));
  UM_CHECK(um_model_run_grey_bodies(context, model, tables, result));
done:
  UM_FREE(context, light.exo_atmospheric, light.at_aperture);
  return status;
}
