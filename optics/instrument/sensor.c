/* Counts and noise of a detector behind a telescope. */
#include "optics/instrument/sensor.h"

#include <math.h>

#include "base/core/constants.h"

#define JANSKY       1e-26  /* [W/m^2/Hz] */
#define DETECTED     5.0    /* SNR of the limiting magnitude [1] */
#define YOUNG        1.5    /* C_Y of Osborn et al. 2015, median of sites [m^(2/3) s^(1/2)] */
#define SCALE_HEIGHT 8000.0 /* of turbulence [m] */

double um_instrument_area(const struct um_instrument_sensor *sensor)
{
  double d = sensor->aperture, o = sensor->obstruction;
  return 0.25 * UM_PI * d * d * (1.0 - o * o);
}

double um_instrument_count_rate(const struct um_instrument_sensor *sensor,
                                const struct um_instrument_bins *bins, const double *spectral)
{
  return um_instrument_area(sensor) / sensor->gain * um_instrument_photons(bins, spectral);
}

/* Photons of F_nu = F_0 in a bin: F_0/h ln(to/from). */
double um_instrument_count_rate_ab0(const struct um_instrument_sensor *sensor,
                                    const struct um_instrument_bins *bins)
{
  double sum = 0.0;
  for (size_t i = 0; i < bins->n; i++)
    sum += (bins->transmission != NULL ? bins->transmission[i] : 1.0) * 2.0 *
           atanh(0.5 * bins->width[i] / bins->wavelength[i]);
  return um_instrument_area(sensor) / sensor->gain * UM_AB_ZERO_JY * JANSKY / UM_PLANCK * sum;
}

double um_instrument_sky_rate(const struct um_instrument_sensor *sensor,
                              const struct um_instrument_bins *bins, const double *radiance)
{
  double side = sensor->pixel / 3600.0 * UM_DEG; /* [rad] */
  return um_instrument_area(sensor) * side * side * um_instrument_photons(bins, radiance);
}

/* Share of a Gaussian image within the pixel that it is centred on. */
static double central_pixel(const struct um_instrument_sensor *sensor)
{
  double sigma = sensor->fwhm / (2.0 * sqrt(2.0 * log(2.0)));
  double side = erf(sensor->pixel / (2.0 * sqrt(2.0) * sigma));
  return side * side;
}

double um_instrument_pixel_background(const struct um_instrument_sensor *sensor,
                                      const struct um_instrument_bins *bins, double glow,
                                      double time)
{
  if (isnan(sensor->pixel)) return NAN;
  double zero = um_instrument_count_rate_ab0(sensor, bins) * sensor->gain;           /* [e/s] */
  double sky = zero * pow(10.0, -0.4 * sensor->sky) * sensor->pixel * sensor->pixel; /* [e/s/px] */
  return (sky + glow + sensor->dark) * time;
}

/* Electrons of the source that a pixel has room for. */
static double room_of(const struct um_instrument_sensor *sensor, double background)
{
  return sensor->saturation - background;
}

double um_instrument_saturated(const struct um_instrument_sensor *sensor, double electrons,
                               double background)
{
  double room = room_of(sensor, background), central = central_pixel(sensor);
  if (!(central * electrons > room)) return electrons;
  if (!(room > 0.0)) return 0.0;
  return room / central * (1.0 + log(central * electrons / room));
}

double um_instrument_unsaturated(const struct um_instrument_sensor *sensor, double found,
                                 double background)
{
  double room = room_of(sensor, background), central = central_pixel(sensor);
  if (!(central * found > room) || !(room > 0.0)) return found;
  return room / central * exp(central * found / room - 1.0);
}

struct um_instrument_exposure um_instrument_expose(const struct um_instrument_sensor *sensor,
                                                   const struct um_instrument_bins *bins,
                                                   double rate, double irradiance, double glow,
                                                   double time)
{
  struct um_instrument_exposure e = {NAN, NAN, NAN, false, NAN, NAN};
  double electrons = rate * sensor->gain * time; /* of the whole image */
  if (!isnan(sensor->noise_equivalent_irradiance))
    e.snr = irradiance / sensor->noise_equivalent_irradiance;
  if (isnan(sensor->pixel)) {
    e.signal = electrons;
    return e;
  }
  double zero = um_instrument_count_rate_ab0(sensor, bins) * sensor->gain; /* [e/s] */
  double q = sensor->radius, radius = q * sensor->fwhm / sensor->pixel;
  double enclosed = 1.0 - exp2(-4.0 * q * q), n = UM_PI * radius * radius;
  double per_pixel = um_instrument_pixel_background(sensor, bins, glow, time);
  double read2 = sensor->read_noise * sensor->read_noise;
  double noise2 = n * (1.0 + n / sensor->annulus) * (per_pixel + read2); /* beside the source's */
  e.signal = enclosed * electrons;
  e.background = n * per_pixel;
  e.peak = central_pixel(sensor) * electrons + per_pixel;
  e.saturated = e.peak > sensor->saturation;
  e.peak = fmin(e.peak, sensor->saturation);
  if (isnan(e.snr)) e.snr = e.signal > 0.0 ? e.signal / sqrt(e.signal + noise2) : 0.0;
  /* x^2 = k^2 (x + N) for the signal x of SNR k */
  double k2 = DETECTED * DETECTED, least = 0.5 * (k2 + sqrt(k2 * k2 + 4.0 * k2 * noise2));
  e.limit_ab = -2.5 * log10(least / (enclosed * time * zero));
  return e;
}

double um_instrument_scintillation(double aperture, double exposure, double airmass, double height)
{
  return sqrt(1e-5 * YOUNG * YOUNG * pow(aperture, -4.0 / 3.0) / exposure * pow(airmass, 3.0) *
              exp(-2.0 * height / SCALE_HEIGHT));
}
