/* A frame as FITS, and photometry of what is in it. */
#include "output/fits.h"

#include <math.h>

#include "instrument/aperture.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_output_fits *f;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_output_read_fits(context, path, &f))) {
    struct um_instrument_aperture_sum sum;
    char text[72];
    double gain = um_output_fits_number(f, "GAIN");
    const struct um_instrument_counts counts = {f->width, f->height, f->value, gain, 1.0, INFINITY};
    const struct um_instrument_aperture a = {.x = 0.5 * (f->width - 1),
                                             .y = 0.5 * (f->height - 1),
                                             .radius = 1.5,
                                             .inside = 2.0,
                                             .beyond = 3.4,
                                             .median = true};
    if (f->width < 1 || f->height < 1 || f->value == NULL) um_fuzz_finding("a picture of nothing");
    um_output_fits_text(f, "DATE-OBS", text);
    if (um_fuzz_good(context, um_instrument_aperture_sum(context, &counts, &a, &sum)) &&
        sum.annulus < 8)
      um_fuzz_finding("a sky of %zu pixels", sum.annulus);
    um_output_fits_destroy(context, &f);
  } else if (f != NULL) {
    um_fuzz_finding("a picture in spite of the failure");
  }
}
