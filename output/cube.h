/* Factored pictures as netCDF-4: what pixels see and the spectra of it, to be expanded later. */
#ifndef UMBRA_OUTPUT_CUBE_H
#define UMBRA_OUTPUT_CUBE_H

#include "optics/image/image.h"
#include "output/exr.h"

/* Layout in docs/files.md. Made in memory, compressed, then written: HDF5 crashes at the end of the
 * process when the disk is full. comments: "" for none. UM_ERR_IO, UM_ERR_MEMORY,
 * UM_ERR_CANCELLED. */
enum um_status um_output_write_cube(struct um_context *context, const struct um_optics_image *image,
                                    const char *comments, const char *path);

/* What of a cube is wanted. */
struct um_output_cube_part {
  double from, to;         /* bins whose centre lies within [m]; 0 and INFINITY: all */
  int x, y, width, height; /* pixels; width 0: all of them */
};
/* Read a part: a picture of all its lines, those outside the part empty, with the wanted bins
 * alone; *cut is the part in it. A child process reads, since the library meets files of any
 * origin. UM_ERR_INPUT: not a cube, damaged, a part outside it (what is accepted is said);
 * UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED. The caller destroys. */
enum um_status um_output_read_cube(struct um_context *context, const char *path,
                                   const struct um_output_cube_part *part,
                                   struct um_optics_image **out, struct um_output_cut *cut);

#endif
