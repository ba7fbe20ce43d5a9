/* A table of a point spread function. */
#include "optics/instrument/psf.h"

#include <math.h>

#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_instrument_psf psf;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_instrument_psf_read(context, path, &psf))) {
    double all = um_instrument_psf_encircled(&psf, INFINITY);
    if (!(fabs(all - 1.0) <= 1e-6)) um_fuzz_finding("an integral of %g", all);
    if (!(um_instrument_psf_at(&psf, 0.5 * psf.radius[psf.n - 1]) >= 0.0))
      um_fuzz_finding("a value below 0");
  } else if (psf.radius != NULL || psf.value != NULL) {
    um_fuzz_finding("a function in spite of the failure");
  }
  um_instrument_psf_clear(context, &psf);
}
