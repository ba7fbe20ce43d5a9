/* Pictures as OpenEXR. */
#ifndef UMBRA_OUTPUT_EXR_H
#define UMBRA_OUTPUT_EXR_H

#include "optics/image/image.h"

#define UM_OUTPUT_COMMENTS 256

/* A part of a picture: a rectangle of pixels, y downward, and a range of its bins. */
struct um_output_cut {
  int x, y, width, height;
  size_t bin, nbin;
  char comments[UM_OUTPUT_COMMENTS]; /* of the file; "": none */
};
struct um_output_cut um_output_cut_whole(const struct um_optics_image *image);

/* Channels "S0.<wavelength>nm" (layout of Fichet et al. 2021, W/m^2/sr/nm), and R, G, B for
 * viewers. cut: what to write, inside the picture; NULL: all of it. The picture is expanded line by
 * line; memory is that of one line per thread. Same bytes for any number of threads. UM_ERR_IO,
 * UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_output_write_exr(struct um_context *context, const struct um_optics_image *image,
                                   const struct um_output_cut *cut, const char *path);

#endif
