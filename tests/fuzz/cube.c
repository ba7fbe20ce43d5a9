/* A factored picture: all of it, and a part. */
#include "output/cube.h"

#include <math.h>

#include "tests/fuzz/fuzz.h"

enum { BINS = 64 };

static void look(const struct um_optics_image *image, const struct um_output_cut *cut)
{
  float value[BINS];
  if (cut->width < 1 || cut->height < 1 || image->nbin < 1) um_fuzz_finding("a picture of nothing");
  for (size_t b = 0; b < image->nbin; b++)
    if (!(image->wavelength[b] > 0.0 && image->bin_width[b] > 0.0))
      um_fuzz_finding("a bin of %g m at %g m", image->bin_width[b], image->wavelength[b]);
  for (int y = cut->y; y < cut->y + cut->height; y++)
    for (int x = cut->x; x < cut->x + cut->width && x < cut->x + 64; x++) {
      const struct um_optics_image_span span = {
          y, x, 1, 0, image->nbin < BINS ? image->nbin : BINS, BINS};
      um_optics_image_expand(image, &span, value);
      for (size_t b = 0; b < span.nbin; b++) um_fuzz_finite((double)value[b], "a radiance");
    }
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const struct um_output_cube_part part[] = {{0.0, INFINITY, 0, 0, 0, 0},
                                                    {0.5e-6, 0.65e-6, 1, 1, 2, 1}};
  const char *path = um_fuzz_out_file(data, size);
  um_fuzz_children_watch();
  for (int k = 0; k < 2; k++) {
    struct um_optics_image *image = NULL;
    struct um_output_cut cut;
    if (um_fuzz_good(context, um_output_read_cube(context, path, &part[k], &image, &cut)))
      look(image, &cut);
    else if (image != NULL)
      um_fuzz_finding("a picture in spite of the failure");
    um_optics_image_destroy(context, &image);
  }
  um_fuzz_children_judge();
}
