/* Aperture photometry: what a circle on a frame holds above the sky of a ring about it. Nothing
 * here fails but what says so. */
#ifndef UMBRA_INSTRUMENT_APERTURE_H
#define UMBRA_INSTRUMENT_APERTURE_H

#include <stdbool.h>

#include "base/core/context.h"

/* Counts [height][width]; the middle of the first pixel is at 0, 0. */
struct um_instrument_counts {
  int width, height;
  const float *value;
  double gain;       /* electrons per count [1] */
  double read_noise; /* [e] */
  double saturation; /* of a pixel [counts]; INFINITY: none */
};
struct um_instrument_aperture {
  double x, y;   /* its middle [pixels] */
  double radius; /* of the circle, the region of interest [pixels] */
  double inside,
      beyond;  /* radii of the sky annulus; pixels whose middle lies there count [pixels] */
  bool median; /* the sky is their median, else their mean */
};
struct um_instrument_aperture_sum {
  double sum;       /* in the circle, pixels that it cuts by their share [counts] */
  double pixels;    /* its area, pi r^2 [pixels] */
  double sky;       /* of a pixel [counts] */
  double sky_error; /* standard error of that [counts] */
  size_t annulus;   /* pixels that it is read from */
  double net;       /* sum less sky [counts] */
  double error;     /* standard error of that [counts] */
  double snr;       /* [1] */
  size_t saturated; /* pixels in the circle, in part or whole, at the saturation */
};

/* Share of the pixel about (i, j) that lies in a circle of radius r about (x, y), exact [1]. */
double um_instrument_pixel_share(double i, double j, double x, double y, double r);

/* By the CCD equation (Merline & Howell 1995; docs/physics/noise.md), in electrons:
 *   variance = S + n (1 + c n/n_a) (B + R^2 + g^2/12),
 * S source, n pixels of the circle, n_a of the annulus, B sky and dark current of a pixel, R read
 * noise, g^2/12 of whole counts; c = 1 for the mean. The median of many Gaussian deviations has c =
 * pi/2, and of counts with Poisson's skew lies B/(6 (B + R^2)) electrons below the mean, which is
 * added; it is that of counts spread evenly over their step, else whole counts would make it jump.
 * A mean is right where nothing but sky is in the annulus, a median where a star may be.
 *
 * UM_ERR_INPUT: a circle or annulus that is not within the frame, radii that are not ascending, an
 * annulus of fewer than 8 pixels, gain or noise that no detector has. UM_ERR_MEMORY. */
enum um_status um_instrument_aperture_sum(struct um_context *context,
                                          const struct um_instrument_counts *counts,
                                          const struct um_instrument_aperture *aperture,
                                          struct um_instrument_aperture_sum *out);

#endif
