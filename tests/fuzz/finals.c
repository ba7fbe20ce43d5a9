/* An IERS finals2000A table. */
#include "orbit/frames.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_orbit_earth_orientation orientation = {0};
  const char *path = um_fuzz_file(0, data, size);
  if (!um_fuzz_good(context, um_orbit_finals_read(context, path, &orientation.finals))) {
    if (orientation.finals != NULL) um_fuzz_finding("a table in spite of the failure");
    return;
  }
  static const double times[] = {5.362e8, 5.3641e8, 5.3650000001e8, -1e9, 3e9};
  for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
    double ut1_utc, xp, yp;
    struct um_mat3 turn;
    if (!um_fuzz_good(context, um_orbit_earth_orientation_at(context, &orientation, times[i],
                                                             &ut1_utc, &xp, &yp)))
      continue;
    um_fuzz_finite(ut1_utc, "UT1-UTC");
    um_fuzz_finite(xp + yp, "the pole");
    (void)um_fuzz_good(context,
                       um_orbit_frames_gcrs_to_itrf(context, &orientation, times[i], &turn));
  }
  um_orbit_finals_destroy(&orientation.finals);
}
