/* What stands in files of FITS, by cfitsio. */
#ifndef UMBRA_OUTPUT_FITS_LIBRARY_H
#define UMBRA_OUTPUT_FITS_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

/* A picture: value[height][width], row 0 below, and the 80 characters of each card of its header.
 * The caller frees value and header. */
struct um_output_fits_picture {
  int width, height;
  float *value;
  char *header;
  size_t ncard;
};

bool um_output_fits_is(const char *bytes, size_t length);
/* The first picture of a file, of any number format, compressed by tiles or not, scaled; NaN where
 * it is blank. Two axes (further ones of length 1), at most 8192 a side. UM_ERR_INPUT naming the
 * file and what is wrong. */
enum um_status um_output_fits_picture(struct um_context *context, const char *path,
                                      const char *bytes, size_t length,
                                      struct um_output_fits_picture *out);
/* The first table with rows as CSV, *csv text of *n bytes, the caller frees: columns of one number
 * or text a row. A column TIME whose file has a reference (MJDREF, JDREF; in whole and fraction or
 * one) becomes that date in days. UM_ERR_INPUT as above, and where TIMESYS is not UTC. */
enum um_status um_output_fits_table(struct um_context *context, const char *path, const char *bytes,
                                    size_t length, char **csv, size_t *n);

#endif
