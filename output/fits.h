/* Pictures as FITS (Pence et al. 2010, A&A 524:A42), the format of astronomers' programs. */
#ifndef UMBRA_OUTPUT_FITS_H
#define UMBRA_OUTPUT_FITS_H

#include "core/context.h"

/* One card of the header: a number, or a text where it is not NULL. */
struct um_output_card {
  const char *key; /* up to 8 of A-Z, 0-9, - and _ */
  double number;
  const char *text;
  const char *comment;
};
/* value[height][width], row 0 on top; FITS begins below. 32-bit floats. It appears whole.
 * UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_output_write_fits(struct um_context *context, const float *value, int width,
                                    int height, const struct um_output_card *cards, size_t ncard,
                                    const char *path);

#endif
