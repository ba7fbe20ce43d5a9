/* Two-line elements and what SGP4 makes of them. */
#include "orbit/tle.h"

#include <stdlib.h>

#include "orbit/sgp4.h"
#include "tests/fuzz/fuzz.h"

static void states(struct um_context *context, const struct um_orbit_tle *tle)
{
  static const double minutes[] = {0.0, 1.0, -1.0, 90.0, -1440.0, 1e5, -1e7, 5e7};
  struct um_orbit_sgp4 *sgp4 = NULL;
  if (!um_fuzz_good(context, um_orbit_sgp4_create(context, tle, &sgp4))) return;
  for (size_t i = 0; i < sizeof minutes / sizeof minutes[0]; i++) {
    struct um_vec3 r, v;
    int code;
    if (!um_fuzz_good(context, um_orbit_sgp4_state(context, sgp4, minutes[i], &r, &v, &code)))
      continue;
    um_fuzz_finite(r.x + r.y + r.z, "a position of SGP4");
    um_fuzz_finite(v.x + v.y + v.z, "a velocity of SGP4");
  }
  um_orbit_sgp4_destroy(&sgp4);
}

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  char *text = um_fuzz_text(data, size);
  /* a changed digit seldom keeps the checksum, so both ways */
  for (int checksum = 0; checksum < 2; checksum++) {
    struct um_orbit_tle tle;
    if (!um_fuzz_good(context, um_orbit_tle_parse(context, text, checksum, &tle))) continue;
    um_fuzz_finite(tle.epoch_tai, "the epoch");
    um_fuzz_finite(tle.mean_motion + tle.bstar, "an element");
    states(context, &tle);
  }
  free(text);
}
