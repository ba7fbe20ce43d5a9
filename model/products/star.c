/* A star of known magnitude through a scenario's air, effects and telescope. */
#include "model/products/star.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "model/build/bands.h"
#include "model/run/run_optics_group.h"

#define JANSKY 1e-26 /* [W/m^2/Hz] */

/* Elevation of an airmass [rad]; what is below that of the zenith is the zenith. */
static double elevation_of(double airmass)
{
  double low = 0.0, high = 0.5 * UM_PI;
  if (isnan(airmass)) return NAN;
  for (int i = 0; i < 60; i++) {
    double middle = 0.5 * (low + high);
    if (um_environment_airmass(middle) > airmass)
      low = middle;
    else
      high = middle;
  }
  return 0.5 * (low + high);
}

/* Irradiance per bin of the star at the aperture and of AB magnitude 0 above the air, [n] each. */
static void fill(const struct um_model *model, const struct um_instrument_bins *bins,
                 double magnitude, double airmass, double *star, double *zero)
{
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  for (size_t i = 0; i < bins->n; i++) {
    double l = bins->wavelength[i], half = 0.5 * bins->width[i], from = l - half, to = l + half;
    double passed = sky->on && !isnan(airmass)
                        ? um_environment_clear_sky_transmission(sky, from, to, airmass)
                        : 1.0;
    /* F_0 c/lambda^2, of which the bin holds as many photons as at its middle: ln(to/from)/(l w) */
    zero[i] = UM_AB_ZERO_JY * JANSKY * UM_LIGHT_SPEED * 2.0 * atanh(half / l) / (l * 2.0 * half);
    star[i] = passed * pow(10.0, -0.4 * magnitude) * zero[i];
  }
}

enum um_status um_model_star_rate(struct um_context *context, const struct um_model *model,
                                  size_t s, double magnitude, double airmass, double t_tai,
                                  double *rate)
{
  enum um_status status;
  const struct um_model_sensor *sensor = &model->sensor[s];
  const struct um_optics_band *band = &model->band[sensor->band];
  struct um_instrument_bins passed = {0};
  double *star = NULL;
  UM_CHECK(um_model_band_bins(context, band, &passed));
  UM_CHECK(um_core_allocate(context, 2 * passed.n, sizeof *star, &star));
  double *zero = star + passed.n;
  struct um_instrument_bins counted = passed;
  counted.transmission = sensor->efficiency;
  fill(model, &passed, magnitude, airmass, star, zero);
  double before = um_instrument_irradiance(&passed, star), after = before;
  struct um_effect_observation at = {.t_tai = t_tai,
                                     .elevation = elevation_of(airmass),
                                     .airmass = airmass,
                                     .band = band->name,
                                     .zero = um_instrument_irradiance(&passed, zero),
                                     .electrons = NAN,
                                     .background = NAN};
  *rate = um_instrument_count_rate(&sensor->optics, &counted, star);
  UM_CHECK(um_model_observe(context, model, NULL, &at, &after));
  if (after != before) *rate *= after / before;
done:
  um_core_free(context, star);
  um_model_band_bins_clear(context, &passed);
  return status;
}
