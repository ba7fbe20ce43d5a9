/* OpenEXR of any planes of floats. Private to output/. */
#ifndef UMBRA_OUTPUT_EXR_IMPL_H
#define UMBRA_OUTPUT_EXR_IMPL_H

#include "base/core/context.h"

/* A picture of named planes, or a rectangle of it, and what is written about it; everything
 * borrowed. */
struct um_output_planes {
  int whole_width, whole_height; /* of the picture [pixels] */
  int x, y, width, height;       /* of what is written, y downward */
  const char *part;              /* what the file calls it */
  size_t nplane;
  char *const *name; /* [nplane] of the channels, all different */
  /* Line y of the picture, 0 on top, into value[width][nplane]; called in threads. */
  void (*row)(const void *self, int y, float *value);
  const void *self;
  size_t ntext, nnumber;
  const char *const (*text)[2]; /* [ntext] name, value */
  const char *const *number_name;
  const double *number; /* [nnumber] */
};
/* Memory is that of one line per thread; the same bytes for any number of threads. UM_ERR_IO with
 * what OpenEXR says; the file appears whole. UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_output_write_planes(struct um_context *context,
                                      const struct um_output_planes *planes, const char *path);

#endif
