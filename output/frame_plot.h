/* A frame as people look at it. */
#ifndef UMBRA_OUTPUT_FRAME_PLOT_H
#define UMBRA_OUTPUT_FRAME_PLOT_H

#include "base/core/context.h"

/* A star's place in a frame, to be marked. */
struct um_output_frame_star {
  double x, y; /* as FITS counts pixels: 1,1 is the middle of the first, below left */
  double magnitude;
};
struct um_output_frame {
  int width, height;
  const float *counts; /* [height][width], row 0 on top */
  double sky;          /* of a pixel [counts] */
  const char *title, *below;
  const struct um_output_frame_star *star; /* [nstar] */
  size_t nstar;
};
/* A PNG at `path` by gnuplot: black where sky is, asinh-stretched so that noise of the sky and the
 * brightest pixel are both seen, axes in pixels as FITS counts them, stars with their magnitude. A
 * missing gnuplot is a logged warning and no picture. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_plot_frame(struct um_context *context, const struct um_output_frame *frame,
                                    const char *path);

#endif
