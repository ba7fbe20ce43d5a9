/* Light curves of the trace: intensities from the renderer, irradiance at the aperture, magnitudes
 * without an atmosphere. */
#include <math.h>
#include <string.h>

#include "model/model_impl.h"
#include "model/run_impl.h"
#include "optics/atmosphere.h"

enum um_status um_model_scene_make(struct um_context *context, const struct um_model *model,
                                   const struct um_model_trace *trace, const double *surface,
                                   struct um_optics_scene *out)
{
  size_t n = trace->nobs * trace->nsub, nsurface = trace->loads->nsurface;
  float *albedo = NULL, *view_factor = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, n * nsurface, sizeof *albedo, &albedo));
  UM_CHECK(um_core_allocate(context, n * nsurface, sizeof *view_factor, &view_factor));
  for (size_t i = 0; i < n; i++) {
    size_t row = trace->load_row[i] * nsurface;
    memcpy(albedo + i * nsurface, trace->loads->albedo + row, nsurface * sizeof *albedo);
    memcpy(view_factor + i * nsurface, trace->loads->view_factor + row,
           nsurface * sizeof *view_factor);
  }
  *out = (struct um_optics_scene){.geometry = model->geometry,
                                  .environment = &model->environment,
                                  .samples = trace->sample,
                                  .view = trace->view,
                                  .material = model->material,
                                  .adjustment = model->adjustment,
                                  .temperature = surface,
                                  .albedo = albedo,
                                  .view_factor = view_factor,
                                  .interreflection_samples =
                                      model->scenario->optics->interreflection_samples};
  return UM_OK;
done:
  um_core_free(context, albedo);
  um_core_free(context, view_factor);
  return status;
}

void um_model_scene_release(struct um_context *context, struct um_optics_scene *scene)
{
  um_core_free(context, (void *)(uintptr_t)scene->albedo);
  um_core_free(context, (void *)(uintptr_t)scene->view_factor);
  scene->albedo = scene->view_factor = NULL;
}

static enum um_status result_arrays(struct um_context *context, const struct um_model_trace *trace,
                                    const struct um_optics_lightcurve *curve,
                                    struct um_model_result *r)
{
  size_t n = trace->nobs;
  r->nband = curve->nband;
  r->nbin = curve->nbin;
  r->nmaterial = curve->nmaterial;
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->irradiance));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->magnitude_ab));
  UM_TRY(um_core_allocate(context, n * r->nband, sizeof(double), &r->standard_error));
  UM_TRY(um_core_allocate(context, n * r->nband * r->nmaterial * UM_MECHANISM_COUNT, sizeof(double),
                          &r->intensity));
  UM_TRY(um_core_allocate(context, n * r->nbin * UM_MECHANISM_COUNT, sizeof(double), &r->spectral));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(double), &r->wavelength));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(double), &r->bin_width));
  UM_TRY(um_core_allocate(context, r->nbin, sizeof(uint32_t), &r->bin_band));
  memcpy(r->wavelength, curve->wavelength, r->nbin * sizeof(double));
  memcpy(r->bin_width, curve->width, r->nbin * sizeof(double));
  memcpy(r->bin_band, curve->band, r->nbin * sizeof(uint32_t));
  return UM_OK;
}

/* Means over the exposure; E = I / R^2 instant by instant. Standard errors of the instants share
 * their sample points, so they are averaged, not reduced. */
static void average(const struct um_model_trace *trace, const struct um_optics_lightcurve *curve,
                    struct um_model_result *r, double *spectral_irradiance)
{
  size_t per_time = r->nband * r->nmaterial * UM_MECHANISM_COUNT;
  size_t per_spectrum = r->nbin * UM_MECHANISM_COUNT;
  double w = 1.0 / (double)trace->nsub;
  for (size_t k = 0; k < trace->nobs; k++) {
    bool below = false;
    memset(spectral_irradiance, 0, r->nbin * sizeof(double));
    for (size_t i = k * trace->nsub; i < (k + 1) * trace->nsub; i++) {
      double range = trace->sample[i].range;
      below = below || trace->look[i].elevation < 0.0;
      for (size_t j = 0; j < per_time; j++)
        r->intensity[k * per_time + j] += w * curve->intensity[i * per_time + j];
      for (size_t j = 0; j < per_spectrum; j++) {
        double value = curve->spectral[i * per_spectrum + j];
        r->spectral[k * per_spectrum + j] += w * value;
        spectral_irradiance[j / UM_MECHANISM_COUNT] += w * value / (range * range);
      }
      for (size_t b = 0; b < r->nband; b++)
        r->standard_error[k * r->nband + b] += w * curve->stderr_[i * r->nband + b];
    }
    size_t first = 0;
    for (size_t b = 0; b < r->nband; b++) {
      size_t n = 0;
      double irradiance = 0.0;
      while (first + n < r->nbin && r->bin_band[first + n] == b) {
        irradiance += spectral_irradiance[first + n] * r->bin_width[first + n];
        n++;
      }
      r->irradiance[k * r->nband + b] = below ? NAN : irradiance;
      r->magnitude_ab[k * r->nband + b] = um_optics_magnitude_ab(
          spectral_irradiance + first, r->wavelength + first, r->bin_width + first, n);
      first += n;
    }
  }
}

/* Band irradiance of a source of magnitude 0 that is the same at every wavelength [W/m^2]. */
static double irradiance_of_zero(const struct um_model_result *r, size_t b,
                                 double *spectral_irradiance)
{
  size_t first = 0, n = 0;
  double width = 0.0;
  while (r->bin_band[first] != b) first++;
  for (; first + n < r->nbin && r->bin_band[first + n] == b; n++) {
    spectral_irradiance[n] = 1.0;
    width += r->bin_width[first + n];
  }
  double unit =
      um_optics_magnitude_ab(spectral_irradiance, r->wavelength + first, r->bin_width + first, n);
  return width * pow(10.0, 0.4 * unit);
}

/* One observation and band through all effects: what comes to the aperture, or, as if there were no
 * atmosphere, what the magnitude is made of. */
static enum um_status transform(struct um_context *context, const struct um_model *model,
                                const struct um_model_trace *trace, size_t k, size_t b,
                                bool exo_atmospheric, double *value)
{
  struct um_effect_use use;
  double elevation = trace->look[k * trace->nsub + trace->nsub / 2].elevation;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);) {
    struct um_effect_observation o = {.t_tai = trace->t_obs[k],
                                      .elevation = elevation,
                                      .airmass = um_optics_airmass(elevation),
                                      .band = model->band[b].name,
                                      .value = *value,
                                      .exo_atmospheric = exo_atmospheric};
    if (use.effect->hooks.observation == NULL) continue;
    UM_TRY(use.effect->hooks.observation(context, &use, &o));
    *value = o.value;
  }
  return UM_OK;
}

/* What effects do to an irradiance on its way to the number that is measured, and to the magnitude:
 * as irradiance, E_0 10^(-0.4 m), and back, so that what is added has no colour of its own. */
static enum um_status observe(struct um_context *context, const struct um_model *model,
                              const struct um_model_trace *trace, struct um_model_result *r,
                              double *spectral_irradiance)
{
  for (size_t b = 0; b < r->nband; b++) {
    double zero = irradiance_of_zero(r, b, spectral_irradiance);
    for (size_t k = 0; k < r->nobs; k++) {
      double *magnitude = &r->magnitude_ab[k * r->nband + b];
      double before = zero * pow(10.0, -0.4 * *magnitude), after = before;
      UM_TRY(transform(context, model, trace, k, b, false, &r->irradiance[k * r->nband + b]));
      UM_TRY(transform(context, model, trace, k, b, true, &after));
      if (after != before) *magnitude = -2.5 * log10(after / zero);
    }
  }
  return UM_OK;
}

enum um_status um_model_run_optics(struct um_context *context, const struct um_model *model,
                                   const struct um_model_trace *trace,
                                   const struct um_model_heat_run *run,
                                   struct um_model_result *result)
{
  enum um_status status;
  struct um_optics_scene scene = {0};
  struct um_optics_lightcurve *curve = NULL;
  double *spectral_irradiance = NULL;
  if (trace->view == NULL) return UM_OK;
  UM_TRY(um_model_scene_make(context, model, trace, run->surface, &scene));
  UM_CHECK(um_optics_lightcurve_compute(context, &scene, model->band, model->nband, &curve));
  UM_CHECK(result_arrays(context, trace, curve, result));
  UM_CHECK(um_core_allocate(context, curve->nbin, sizeof(double), &spectral_irradiance));
  average(trace, curve, result, spectral_irradiance);
  UM_CHECK(observe(context, model, trace, result, spectral_irradiance));
done:
  um_core_free(context, spectral_irradiance);
  um_optics_lightcurve_destroy(context, &curve);
  um_model_scene_release(context, &scene);
  return status;
}
