/* A telescope with its detector: photons to counts, and how well they can be told from noise.
 * Nothing here fails. */
#ifndef UMBRA_INSTRUMENT_SENSOR_H
#define UMBRA_INSTRUMENT_SENSOR_H

#include <stdbool.h>

#include "optics/instrument/photometry.h"

struct um_instrument_sensor {
  double aperture;    /* diameter [m] */
  double obstruction; /* diameter of what stands before it, of the aperture's [1] */
  double gain;        /* electrons per count [1] */
  double pixel;       /* side, on the sky [arcsec]; NAN: pixels are not known */
  double fwhm;        /* of a star's image, a Gaussian [arcsec] */
  double radius;      /* of the circle in which counts are summed, of the FWHM [1] */
  double annulus;     /* pixels that the background is read from; INFINITY: it is known [1] */
  double read_noise;  /* [e per pixel and exposure] */
  double dark;        /* [e/s per pixel] */
  double sky;         /* brightness, AB [mag/arcsec^2]; INFINITY: dark */
  double emissivity, temperature;     /* of mirrors, lenses and windows, as they glow [1], [K] */
  double saturation;                  /* of a pixel [e]; INFINITY: none */
  double noise_equivalent_irradiance; /* through the filter, of one exposure [W/m^2]; NAN: by
                                         photons and the noise above */
};

/* Free area of the aperture, pi/4 D^2 (1 - o^2) [m^2]. */
double um_instrument_area(const struct um_instrument_sensor *sensor);
/* Counts per second of irradiance per bin,
 *   C = (A/g) int E T lambda/(h c) d lambda,
 * where T of the bins holds filter, optics and quantum efficiency (docs/physics/instrument.md). */
double um_instrument_count_rate(const struct um_instrument_sensor *sensor,
                                const struct um_instrument_bins *bins, const double *spectral);
/* The same of a source of AB magnitude 0. */
double um_instrument_count_rate_ab0(const struct um_instrument_sensor *sensor,
                                    const struct um_instrument_bins *bins);

/* One exposure of a point source. */
struct um_instrument_exposure {
  double signal;     /* within the circle [e] */
  double background; /* sky and dark within the circle [e] */
  double peak;       /* brightest pixel, centred on it, at most what it holds [e] */
  bool saturated;
  double snr;      /* [1] */
  double limit_ab; /* magnitude at the aperture at which that would be 5; NAN: no pixels [mag] */
};
/* Electrons per second and pixel of a sky of radiance per bin [n] [W/m^2/sr/m]. */
double um_instrument_sky_rate(const struct um_instrument_sensor *sensor,
                              const struct um_instrument_bins *bins, const double *radiance);
/* Electrons of a pixel beside the source in an exposure of `time` [s]: the stated sky, dark current
 * and glow, which is in electrons per second and pixel. NAN: no pixels are known. */
double um_instrument_pixel_background(const struct um_instrument_sensor *sensor,
                                      const struct um_instrument_bins *bins, double glow,
                                      double time);
/* Electrons that are found of an image of so many, where pixels hold no more than the sensor's
 * saturation: the core of a Gaussian image is cut at c, what a pixel has room for beside its
 * background, while its wings go on growing,
 *   S' = S where g S <= c, else (c/g) (1 + ln(g S/c)),   g the share of the central pixel;
 * the integral of min(s(r), c) over the image. No charge flows over to neighbours. */
double um_instrument_saturated(const struct um_instrument_sensor *sensor, double electrons,
                               double background);
/* The image of which so many are found: the inverse. */
double um_instrument_unsaturated(const struct um_instrument_sensor *sensor, double found,
                                 double background);
/* glow: electrons per second and pixel beside the stated sky; rate: counts per second of the whole
 * source; irradiance: through the filter [W/m^2]; time: length of the exposure [s]. SNR by the CCD
 * equation (Merline & Howell 1995, Exp. Astron. 6:163), S t / sqrt(S t + n (1 + n/n_a) (B t + D t +
 * R^2)), n pixels in the circle, of which a Gaussian fills 1 - 2^(-4 q^2) for a radius of q FWHM;
 * or irradiance over the noise-equivalent one. */
struct um_instrument_exposure um_instrument_expose(const struct um_instrument_sensor *sensor,
                                                   const struct um_instrument_bins *bins,
                                                   double rate, double irradiance, double glow,
                                                   double time);

/* Relative fluctuation by scintillation [1], an upper bound for what moves fast (Young 1967, AJ
 * 72:747; Osborn et al. 2015, MNRAS 452:1707), C_Y = 1.5:
 *   sigma^2 = 1e-5 C_Y^2 D^(-4/3) t^-1 X^3 exp(-2 h/8000 m).
 * height of the telescope [m], exposure [s]. */
double um_instrument_scintillation(double aperture, double exposure, double airmass, double height);

#endif
