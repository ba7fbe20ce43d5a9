/* What the child process of cube_send.c sends to cube_read.c. Private to output/. */
#ifndef UMBRA_OUTPUT_CUBE_SEND_IMPL_H
#define UMBRA_OUTPUT_CUBE_SEND_IMPL_H

#include <stdbool.h>
#include <stdint.h>

#include "output/cube.h"

#define UM_CUBE_MESSAGE 400

/* What the child sends first; then wavelengths, widths, transmissions [nbin], surfaces [nspectrum],
 * dark and sun [nspectrum][nbin], and for each line of the part its head and its arrays. */
struct um_cube_header {
  char message[UM_CUBE_MESSAGE]; /* "": all is well */
  char comments[UM_OUTPUT_COMMENTS];
  int32_t width, height, samples, x, y, columns, lines;
  double pixel_size;
  uint64_t nspectrum, nbin, bin /* in the file */;
};
struct um_cube_line {
  uint32_t from, pixels, shares;
};

struct um_cube_wanted {
  const char *path;
  struct um_output_cube_part part;
};

/* Does the part lie inside the picture? */
static inline bool um_cube_part_fits(const struct um_cube_header *h)
{
  return h->x >= 0 && h->y >= 0 && h->columns >= 1 && h->lines >= 1 &&
         h->x <= h->width - h->columns && h->y <= h->height - h->lines;
}

/* Work of a child process (um_core_child_run): a struct um_cube_wanted, as its answer. */
int um_output_cube_send(void *wanted, int pipe_end);

#endif
