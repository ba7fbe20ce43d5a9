/* Counts of an exposure by a run's sensors. */
#include "model/run/counts.h"

#include <math.h>

#include "base/core/planck.h"
#include "environment/airmass.h"
#include "model/run/sky_light.h"

struct um_instrument_bins um_model_bins(const struct um_model_result *result, size_t band,
                                        const double *efficiency)
{
  size_t first = 0, n = 0;
  while (result->bin_band[first] != band) first++;
  while (first + n < result->nbin && result->bin_band[first + n] == band) n++;
  return (struct um_instrument_bins){n, result->wavelength + first, result->bin_width + first,
                                     efficiency != NULL ? efficiency
                                                        : result->transmission + first};
}

/* Mean radiance of what glows before the detector, air and telescope, over a bin [W/m^2/sr/m]. */
static double background(const struct um_environment_clear_sky *sky,
                         const struct um_instrument_sensor *sensor, double elevation, double from,
                         double to)
{
  double radiance = 0.0, airmass = um_environment_airmass_toward(elevation);
  if (sky->on && !isnan(airmass))
    radiance = um_environment_clear_sky_radiance(sky, from, to, airmass);
  if (sensor->emissivity > 0.0)
    radiance +=
        sensor->emissivity * um_core_planck_band(from, to, sensor->temperature) / (to - from);
  return radiance;
}

/* Electrons per second and pixel of it. */
static double glow(const struct um_model *model, const struct um_model_tables *tables, size_t k,
                   const struct um_instrument_sensor *sensor, const struct um_instrument_bins *bins)
{
  double elevation = tables->look[k * tables->nsub + tables->nsub / 2].elevation;
  double sum = 0.0;
  struct um_model_sky scattered;
  if (isnan(sensor->pixel)) return 0.0;
  um_model_sky(model, tables, k, bins->wavelength[0] - 0.5 * bins->width[0],
               bins->wavelength[bins->n - 1] + 0.5 * bins->width[bins->n - 1], &scattered);
  for (size_t i = 0; i < bins->n; i++) {
    double half = 0.5 * bins->width[i], l = bins->wavelength[i];
    struct um_instrument_bins one = {1, &l, &bins->width[i], &bins->transmission[i]};
    double radiance = um_model_sky_radiance(&scattered, l - half, l + half);
    radiance += background(&model->environment.sky, sensor, elevation, l - half, l + half);
    sum += um_instrument_sky_rate(sensor, &one, &radiance);
  }
  return sum;
}

double um_model_pixel_background(const struct um_model *model, const struct um_model_tables *tables,
                                 const struct um_model_result *result, size_t k, size_t s)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  struct um_instrument_bins bins = um_model_bins(result, sensor->band, sensor->efficiency);
  double glowing = glow(model, tables, k, &sensor->optics, &bins);
  return um_instrument_pixel_background(&sensor->optics, &bins, glowing, sensor->exposure);
}

struct um_instrument_exposure um_model_expose(const struct um_model *model,
                                              const struct um_model_tables *tables,
                                              const struct um_model_result *result, size_t k,
                                              size_t s)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  struct um_instrument_bins bins = um_model_bins(result, sensor->band, sensor->efficiency);
  if (tables->hidden[k]) return (struct um_instrument_exposure){NAN, NAN, NAN, false, NAN, NAN};
  return um_instrument_expose(&sensor->optics, &bins, result->count_rate[k * result->nsensor + s],
                              result->irradiance[k * result->nband + sensor->band],
                              glow(model, tables, k, &sensor->optics, &bins), sensor->exposure);
}

double um_model_scintillation(const struct um_model *model, const struct um_model_tables *tables,
                              size_t k, size_t s)
{
  const struct um_model_sensor *sensor = &model->sensor[s];
  double elevation = tables->look[k * tables->nsub + tables->nsub / 2].elevation;
  double airmass = um_environment_airmass_toward(elevation);
  if (isnan(airmass) || !(sensor->exposure > 0.0) || tables->hidden[k]) return NAN;
  return um_instrument_scintillation(sensor->optics.aperture, sensor->exposure, airmass,
                                     model->station[um_model_tables_station(tables, k)].height);
}
