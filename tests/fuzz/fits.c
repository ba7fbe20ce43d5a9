/* A frame as FITS, and photometry of what is in it. */
#include "output/fits.h"

#include <math.h>

#include "evidence/inversion/photometry.h"
#include "tests/fuzz/fuzz.h"

/* As `umbra photometry` measures it, and the row that comes of it. */
static void measure(struct um_context *context, const char *path)
{
  const struct um_instrument_aperture a = {
      .x = NAN, .y = NAN, .radius = 1.5, .inside = 2.0, .beyond = 3.4};
  struct um_compare_photometry p;
  struct um_compare_measurements *rows = NULL;
  if (!um_fuzz_good(context, um_compare_photometry_measure(context, path, &a, &p))) return;
  um_fuzz_finite(p.t_tai, "a time");
  um_fuzz_finite(p.rate, "a count rate");
  um_fuzz_finite(p.sigma, "the error of a count rate");
  if (um_fuzz_good(context, um_compare_photometry_set(context, &p, 1, "fuzz.fits", &rows)) &&
      rows->count != 1)
    um_fuzz_finding("%zu rows of one frame", rows->count);
  um_compare_measurements_destroy(context, &rows);
}

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
  measure(context, path);
}
