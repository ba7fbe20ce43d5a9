/* An orbit as a CSV of positions, with or without velocities. */
#include <math.h>

#include "orbit/trajectory.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_orbit_trajectory *table = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (!um_fuzz_good(context, um_orbit_trajectory_create_table(context, path, NULL, &table))) {
    if (table != NULL) um_fuzz_finding("an orbit in spite of the failure");
    return;
  }
  double first, last;
  um_orbit_trajectory_span(table, &first, &last);
  if (!(first <= last)) um_fuzz_finding("the table spans %g to %g", first, last);
  for (int i = -1; i <= 9; i++) {
    struct um_vec3 r, v;
    double t = first + (last - first) * (double)i / 8.0;
    if (!um_fuzz_good(context, um_orbit_trajectory_state(context, table, t, &r, &v))) continue;
    um_fuzz_finite(r.x + r.y + r.z, "a position");
    um_fuzz_finite(v.x + v.y + v.z, "a velocity");
  }
  double period = um_orbit_trajectory_period(table);
  if (!(period > 0.0) && !isnan(period)) um_fuzz_finding("the period is %g s", period);
  um_orbit_trajectory_destroy(&table);
}
