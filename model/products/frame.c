/* From a run to a detector: the picture of an instant, turned into electrons and spread. */
#include "model/products/frame.h"

#include <math.h>

#include "base/core/constants.h"
#include "effects/effects.h"
#include "environment/airmass.h"
#include "model/build/effects_group.h"
#include "model/products/picture.h"
#include "model/run/counts.h"

#define ARCSEC (UM_DEG / 3600.0)

static const struct um_orbit_look *look_of(const struct um_model_tables *tables, size_t k)
{
  return &tables->look[k * tables->nsub + tables->nsub / 2];
}

/* Mean wavelength of a band's bins, weighted by what passes [m]. */
static double mean_wavelength(const struct um_instrument_bins *bins)
{
  double sum = 0.0, weight = 0.0;
  for (size_t i = 0; i < bins->n; i++) {
    sum += bins->transmission[i] * bins->width[i] * bins->wavelength[i];
    weight += bins->transmission[i] * bins->width[i];
  }
  return weight > 0.0 ? sum / weight : bins->wavelength[bins->n / 2];
}

static enum um_status spread_create(struct um_context *context,
                                    const struct um_model_frame_options *options,
                                    const struct um_instrument_sensor *sensor, double wavelength,
                                    double elevation, struct um_instrument_psf *out)
{
  *out = (struct um_instrument_psf){.kind = UM_PSF_GAUSSIAN, .fwhm = sensor->fwhm};
  switch (options->spread) {
  case UM_SPREAD_GAUSSIAN:
    return UM_OK;
  case UM_SPREAD_MOFFAT:
    out->kind = UM_PSF_MOFFAT;
    out->beta = options->beta;
    return UM_OK;
  case UM_SPREAD_AIRY:
    out->kind = UM_PSF_AIRY;
    out->diffraction = wavelength / sensor->aperture / ARCSEC;
    out->obstruction = sensor->obstruction;
    out->fwhm = 1.028 * out->diffraction;
    return UM_OK;
  case UM_SPREAD_SEEING:
    if (isnan(um_environment_airmass_toward(elevation)))
      return um_core_fail(context, UM_ERR_INPUT,
                          "turbulence needs a station and a satellite above its horizon");
    out->kind = UM_PSF_MOFFAT;
    out->beta = UM_INSTRUMENT_SEEING_BETA;
    out->fwhm = um_instrument_seeing_fwhm(options->r0, wavelength,
                                          um_environment_airmass_toward(elevation));
    return UM_OK;
  case UM_SPREAD_FILE:
    break;
  }
  return um_instrument_psf_read(context, options->path, out);
}

/* Electrons per second of each pixel of the picture, in all those of the run. */
static enum um_status electrons(struct um_context *context, const struct um_optics_image *image,
                                const struct um_instrument_bins *bins, double total, double **out)
{
  double *weight = NULL, sum = 0.0, (*weighed)[2] = NULL;
  size_t n = (size_t)image->width * (size_t)image->height;
  enum um_status status;
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  UM_CHECK(um_core_allocate(context, image->nbin, sizeof *weight, &weight));
  UM_CHECK(um_core_allocate(context, image->nspectrum, sizeof *weighed, &weighed));
  for (size_t b = 0; b < image->nbin; b++) /* photons: E lambda/(h c) */
    weight[b] = bins->transmission[b] * bins->width[b] * bins->wavelength[b];
  um_optics_image_weigh(image, weight, weighed);
  for (size_t i = 0; i < n; i++) {
    (*out)[i] =
        um_optics_image_pixel(image, (const double(*)[2])weighed, (int)(i % (size_t)image->width),
                              (int)(i / (size_t)image->width));
    sum += (*out)[i];
  }
  for (size_t i = 0; i < n; i++) (*out)[i] *= sum > 0.0 ? total / sum : 0.0;
done:
  UM_FREE(context, weight, weighed);
  return status;
}

static enum um_status check(struct um_context *context, const struct um_model *model,
                            const struct um_model_tables *tables, size_t k, size_t s)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  if (tables->hidden[k])
    return um_core_fail(context, UM_ERR_INPUT,
                        "sensor '%s' sees nothing at that time: below the horizon, or behind the "
                        "Earth",
                        sensor->name);
  if (isnan(sensor->optics.pixel))
    return um_core_fail(context, UM_ERR_INPUT, "sensors.%s.pixel_arcsec: a frame needs it",
                        sensor->name);
  if (!(sensor->exposure > 0.0))
    return um_core_fail(context, UM_ERR_INPUT, "sensors.%s.exposure_s: a frame needs it",
                        sensor->name);
  return UM_OK;
}

/* Electrons per second of the whole image as they come to the detector, whose pixels the frame
 * fills itself: what the effect took of the run's count rate is put back. */
static double arriving(const struct um_model *model, const struct um_model_result *result, size_t k,
                       size_t s, double background)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  const struct um_effect *saturation = um_effects_find("saturation");
  double rate = result->count_rate[k * result->nsensor + s] * sensor->optics.gain;
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect == saturation)
      return um_instrument_unsaturated(&sensor->optics, rate * sensor->exposure, background) /
             sensor->exposure;
  return rate;
}

enum um_status um_model_frame_create(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_result *result, size_t k, size_t s,
                                     const struct um_model_frame_options *options,
                                     struct um_model_frame *out)
{
  *out = (struct um_model_frame){.fwhm = NAN};
  UM_TRY(check(context, model, tables, k, s));
  enum um_status status;
  const struct um_model_sensor *sensor = &model->sensor[s];
  const struct um_orbit_look *look = look_of(tables, k);
  struct um_instrument_bins bins = um_model_bins(result, sensor->band, sensor->efficiency);
  struct um_instrument_psf psf = {0};
  struct um_optics_image *image = NULL;
  double *rate = NULL;
  out->background = um_model_pixel_background(model, tables, result, k, s);
  UM_CHECK(spread_create(context, options, &sensor->optics, mean_wavelength(&bins), look->elevation,
                         &psf));
  UM_CHECK(um_model_picture(context, model, tables, result, k, sensor->band, 1, options->width,
                            options->samples, &image));
  UM_CHECK(electrons(context, image, &bins, arriving(model, result, k, s, out->background), &rate));
  const struct um_instrument_source source = {image->width, image->height,
                                              image->pixel_size / look->range / ARCSEC, rate};
  const struct um_instrument_frame_options on = {.pixel = sensor->optics.pixel,
                                                 .exposure = sensor->exposure,
                                                 .trail = options->motion * sensor->exposure,
                                                 .trail_angle = options->motion_angle,
                                                 .border = options->border,
                                                 .star = options->star,
                                                 .nstar = options->nstar};
  UM_CHECK(um_instrument_frame_create(context, &source, &psf, &on, &out->frame));
  if (psf.kind != UM_PSF_TABLE) out->fwhm = psf.fwhm;
done:
  um_core_free(context, rate);
  um_optics_image_destroy(context, &image);
  um_instrument_psf_clear(context, &psf);
  return status;
}

void um_model_frame_clear(struct um_context *context, struct um_model_frame *frame)
{
  um_instrument_frame_clear(context, &frame->frame);
}
