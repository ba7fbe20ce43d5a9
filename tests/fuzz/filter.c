/* A curve between 0 and 1 by wavelength: a filter, a quantum efficiency. */
#include "optics/instrument/filter.h"

#include <math.h>

#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_instrument_filter *f = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (!um_fuzz_good(context, um_instrument_filter_read(context, path, &f))) {
    if (f != NULL) um_fuzz_finding("a curve in spite of the failure");
    return;
  }
  double from = f->wavelength[0], to = f->wavelength[f->n - 1];
  double pivot = um_instrument_filter_pivot(f);
  if (!(pivot >= from * (1.0 - 1e-6) && pivot <= to * (1.0 + 1e-6)))
    um_fuzz_finding("a pivot of %.17g m between %.17g and %.17g m", pivot, from, to);
  for (int k = 0; k < 8; k++) {
    double low = from + (to - from) * k / 8.0, high = low + (to - from) / 5.0;
    if (!(low < high)) continue; /* neighbouring numbers */
    double mean = um_instrument_filter_mean(f, low, high);
    if (!(mean >= -1e-12 && mean <= 1.0 + 1e-12)) um_fuzz_finding("a mean of %.17g", mean);
  }
  um_instrument_filter_destroy(context, &f);
}
