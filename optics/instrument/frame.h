/* What a detector sees of an extended source: blurred, smeared, in pixels, with noise. */
#ifndef UMBRA_INSTRUMENT_FRAME_H
#define UMBRA_INSTRUMENT_FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "optics/instrument/psf.h"

#define UM_INSTRUMENT_FRAME_SIDE 4096 /* pixels */

/* The source on the sky before air and telescope. */
struct um_instrument_source {
  int width, height;
  double pixel;       /* [arcsec] */
  const double *rate; /* [height][width] [e/s] */
};
/* A point of light beside it, which does not move with it. */
struct um_instrument_frame_star {
  double x, y; /* right of the frame's middle and above it [arcsec] */
  double rate; /* [e/s] */
};
struct um_instrument_frame_options {
  double pixel;       /* of the detector [arcsec] */
  double exposure;    /* [s] */
  double trail;       /* by which the image moves while it is exposed [arcsec] */
  double trail_angle; /* of that, from the right counter-clockwise [rad] */
  int border;         /* pixels of sky about what the source fills, beside the spread function */
  const struct um_instrument_frame_star *star; /* [nstar] */
  size_t nstar;
};
/* Expected electrons of the source, without sky and noise. */
struct um_instrument_frame {
  int width, height;
  double pixel;      /* [arcsec] */
  double *electrons; /* [height][width], row 0 on top [e] */
  double source;     /* of the whole source [e] */
  double stars;      /* of all stars [e] */
  double outside;    /* of both, what the frame does not hold: wings of the spread function [e] */
};

/* The source's middle lies in the frame's, which is as large as source and stars want it. Light is
 * gathered in cells of a third of a pixel, moved along the trail, spread by the kernel and summed
 * in pixels. Of a Gaussian or Moffat function 1e-6 of the light or less is outside; of Airy's what
 * stands beyond 512 cells. Direct: every cell of the source spreads once, so the cost is the
 * product of the source's cells and the kernel's. UM_ERR_INPUT: a frame of more than 4096 pixels a
 * side, a spread function that cells do not resolve; UM_ERR_MEMORY; UM_ERR_CANCELLED. */
enum um_status um_instrument_frame_create(struct um_context *context,
                                          const struct um_instrument_source *source,
                                          const struct um_instrument_psf *psf,
                                          const struct um_instrument_frame_options *options,
                                          struct um_instrument_frame *out);
void um_instrument_frame_clear(struct um_context *context, struct um_instrument_frame *frame);

/* How electrons become counts. */
struct um_instrument_readout {
  double background; /* sky and dark current of a pixel [e] */
  double read_noise; /* [e] */
  double gain;       /* electrons per count [1] */
  double saturation; /* of a pixel [e]; INFINITY: none */
  uint64_t seed;
  bool noiseless; /* expected counts, not rounded */
};
/* counts[height][width]: Poisson's photons and dark electrons up to the saturation, Gaussian read
 * noise, whole counts with the camera's offset subtracted, so that faint pixels may be negative. A
 * pixel's noise depends on seed and place alone. Returns how many pixels are saturated. */
size_t um_instrument_frame_read(const struct um_instrument_frame *frame,
                                const struct um_instrument_readout *readout, float *counts);

#endif
