/* Files of element sets, and the orbit by what is read of them. */
#include "orbit/elements.h"

#include "orbit/trajectory.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  static const double days[] = {0.0, 1.0, -400.0};
  const struct um_orbit_earth_orientation eop = {0};
  struct um_orbit_elements sets;
  struct um_orbit_trajectory *orbit = NULL;
  if (!um_fuzz_good(context,
                    um_orbit_elements_parse(context, "sets", (const char *)data, size, 0, &sets)))
    return;
  double first = sets.set[0].epoch_tai;
  um_fuzz_finite(first + sets.set[sets.count - 1].epoch_tai, "an epoch");
  if (um_fuzz_good(context,
                   um_orbit_trajectory_create_elements(context, &sets, first, &eop, &orbit)))
    for (size_t i = 0; i < sizeof days / sizeof days[0]; i++) {
      struct um_vec3 r, v;
      if (um_fuzz_good(context, um_orbit_trajectory_state(context, orbit, first + 86400.0 * days[i],
                                                          &r, &v)))
        um_fuzz_finite(um_vec3_norm(r) + um_vec3_norm(v), "a state");
    }
  um_orbit_trajectory_destroy(&orbit);
  um_orbit_elements_release(context, &sets);
}
