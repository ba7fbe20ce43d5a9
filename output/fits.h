/* Pictures as FITS (Pence et al. 2010, A&A 524:A42), the format of astronomers' programs. */
#ifndef UMBRA_OUTPUT_FITS_H
#define UMBRA_OUTPUT_FITS_H

#include "base/core/context.h"

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

/* A picture that was read: value[height][width], row 0 below as in the file, and its header. */
struct um_output_fits {
  char *path;
  int width, height;
  float *value;
  char *header; /* cards of 80 characters without END */
  size_t ncard;
};
/* The first picture of a file, of any number format, compressed by tiles or not, scaled; NaN where
 * it is blank. Two axes (further ones of length 1), at most 8192 a side.
 * UM_ERR_IO, UM_ERR_INPUT naming the file and what is wrong, UM_ERR_MEMORY. The caller destroys. */
enum um_status um_output_read_fits(struct um_context *context, const char *path,
                                   struct um_output_fits **out);
void um_output_fits_destroy(struct um_context *context, struct um_output_fits **fits);
/* A number of the header by its key; NAN: there is none. */
double um_output_fits_number(const struct um_output_fits *fits, const char *key);
/* A text of it, without quotes and blanks at its end; "" where there is none. */
void um_output_fits_text(const struct um_output_fits *fits, const char *key, char out[72]);

#endif
