/* Transmission and radiance of air, as another program computed them. */
#include <math.h>

#include "environment/sky_table.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_environment_sky_table *table = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (!um_fuzz_good(context, um_environment_sky_table_read(context, path, &table))) {
    if (table != NULL) um_fuzz_finding("a table in spite of the failure");
    return;
  }
  for (int k = 0; k < 12; k++) {
    double from = 0.1e-6 * pow(1.7, k), to = from * 1.3;
    if (!um_environment_sky_table_covers(table, from, to)) continue;
    for (double airmass = 1.0; airmass < 40.0; airmass *= 2.3) {
      double t = um_environment_sky_table_transmission(table, from, to, airmass);
      double radiance = um_environment_sky_table_radiance(table, from, to, airmass);
      if (!(t >= 0.0 && t <= 1.0 + 1e-9)) um_fuzz_finding("a transmission of %.17g", t);
      if (!(radiance >= 0.0 && isfinite(radiance))) um_fuzz_finding("a radiance of %g", radiance);
    }
  }
  um_environment_sky_table_destroy(context, &table);
}
