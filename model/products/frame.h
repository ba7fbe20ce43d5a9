/* What a sensor's detector records of an observation. */
#ifndef UMBRA_MODEL_FRAME_H
#define UMBRA_MODEL_FRAME_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "optics/instrument/frame.h"

/* How a point of light is spread, as a user says it. */
enum um_model_spread {
  UM_SPREAD_GAUSSIAN, /* the sensor's FWHM */
  UM_SPREAD_MOFFAT,   /* that, with beta */
  UM_SPREAD_AIRY,     /* the sensor's aperture and obstruction at the band's mean wavelength */
  UM_SPREAD_SEEING, /* a Moffat function with the FWHM of turbulence at that wavelength and airmass
                     */
  UM_SPREAD_FILE
};
struct um_model_frame_options {
  enum um_model_spread spread;
  double beta; /* Moffat */
  double r0;   /* at 500 nm and the zenith [m] */
  const char *path;
  double motion, motion_angle; /* of the image [arcsec/s], from the right counter-clockwise [rad] */
  int border;                  /* pixels of sky about what the light fills, 1 or more */
  const struct um_instrument_frame_star *star; /* [nstar] beside the satellite */
  size_t nstar;
  int width, samples; /* of the picture that is put on the detector */
};
struct um_model_frame {
  struct um_instrument_frame frame;
  double background; /* sky and dark current of a pixel [e] */
  double fwhm;       /* of the spread function [arcsec]; NaN: a file's */
};

/* Observation k through sensor s, up being away from the Earth: the picture of its band, weighted
 * by photons, whose sum is the run's count rate. UM_ERR_INPUT: hidden, a sensor without pixels or
 * exposure, turbulence without air, and those of um_instrument_frame_create. The caller clears. */
enum um_status um_model_frame_create(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_result *result, size_t k, size_t s,
                                     const struct um_model_frame_options *options,
                                     struct um_model_frame *out);
void um_model_frame_clear(struct um_context *context, struct um_model_frame *frame);

#endif
