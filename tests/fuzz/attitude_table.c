/* Attitudes as a CSV of quaternions. */
#include <math.h>

#include "orbit/attitude.h"
#include "orbit/time.h"
#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_TABLE, .from_tai = -INFINITY};
  law.table_path = um_fuzz_file(0, data, size);
  struct um_orbit_attitude *attitude = NULL;
  if (!um_fuzz_good(context, um_orbit_attitude_create(context, &law, 1, &attitude))) {
    if (attitude != NULL) um_fuzz_finding("an attitude in spite of the failure");
    return;
  }
  um_fuzz_finite(um_orbit_attitude_rate(attitude, 1e-3), "the rate of turn");
  double start;
  if (um_fuzz_good(context, um_orbit_time_parse(context, "2016-03-20T04:30:00Z", &start)))
    for (int i = 0; i < 12; i++) {
      const struct um_orbit_attitude_input input = {
          .t_tai = start + 3.0 * i, .r = {7e6, 0, 0}, .v = {0, 7e3, 0}, .sun = {1, 0, 0}};
      struct um_quat q;
      if (!um_fuzz_good(context, um_orbit_attitude_at(context, attitude, &input, &q))) continue;
      double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
      if (!(fabs(norm - 1.0) < 1e-9)) um_fuzz_finding("a quaternion of norm %.17g", sqrt(norm));
    }
  um_orbit_attitude_destroy(&attitude);
}
