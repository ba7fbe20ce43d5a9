/* UTC with as many digits as a time needs. */
#include "evidence/measurements/time_text.h"

#include <math.h>
#include <stdio.h>

#include "orbit/time.h"

void um_compare_time_text(double t_tai, char out[40])
{
  char head[32];
  double t_head;
  um_orbit_time_format(t_tai, head);
  snprintf(out, 40, "%s", head);
  /* the rest [us] behind the millisecond at or before t; a double of t_tai resolves 0.1 us */
  if (um_orbit_time_parse(NULL, head, &t_head) != UM_OK) return;
  long rest = lround(1e6 * (t_tai - t_head));
  if (rest < 0) {
    um_orbit_time_format(t_head - 0.001, head);
    rest += 1000;
  }
  if (rest > 0) snprintf(out, 40, "%.23s%03uZ", head, (unsigned)rest % 1000U);
}
