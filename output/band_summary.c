/* The light of a band over a run in a few numbers. */
#include "output/band_summary.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/order.h"

struct um_output_band_summary um_output_band_summary(const struct um_model_tables *tables,
                                                     const struct um_model_result *r, size_t band,
                                                     double *work)
{
  struct um_output_band_summary s = {.low = INFINITY, .median = NAN, .umbra_low = INFINITY};
  for (size_t k = 0; k < r->nobs; k++) {
    double total = um_model_result_intensity(r, k, band, -1);
    s.low = fmin(s.low, total);
    s.high = fmax(s.high, total);
    if (total > 0.0) work[s.lit++] = r->standard_error[k * r->nband + band] / total;
    if (tables->sunlit[k] > UM_UMBRA_MOST) continue;
    s.umbra++;
    s.umbra_sun = fmax(s.umbra_sun, um_model_result_intensity(r, k, band, UM_MECHANISM_SUN));
    s.umbra_low = fmin(s.umbra_low, total);
  }
  if (s.lit == 0) return s;
  qsort(work, s.lit, sizeof *work, um_core_order_double);
  s.error = work[s.lit - 1];
  s.median = 0.5 * (work[(s.lit - 1) / 2] + work[s.lit / 2]);
  for (size_t i = s.lit; i > 0 && work[i - 1] > UM_OUTPUT_LARGE_ERROR; i--) s.large++;
  return s;
}
