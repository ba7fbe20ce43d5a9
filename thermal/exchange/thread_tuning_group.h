/* Private to the rooms of thermal/: on how many threads patches exchange radiation. What comes out
 * does not depend on it: every sum is one thread's. */
#ifndef UMBRA_THERMAL_THREAD_TUNING_GROUP_H
#define UMBRA_THERMAL_THREAD_TUNING_GROUP_H

#include <stdbool.h>

struct um_thermal_exchange;
struct um_thermal_between;
struct um_thermal_mix;

struct um_thermal_thread_tuning {
  int threads;          /* at most; below 2: always one */
  bool together;        /* they are used */
  unsigned left;        /* products until the next trial; 0: in one */
  unsigned trial;       /* products of it so far */
  unsigned hold;        /* products between trials */
  double alone, shared; /* [s] of an entry on one thread, on all */
};
/* As um_thermal_exchange_apply. */
void um_thermal_thread_tuning_apply(struct um_thermal_thread_tuning *tuning,
                                    const struct um_thermal_exchange *exchange,
                                    const struct um_thermal_between *between,
                                    const struct um_thermal_mix *mix, const double *x,
                                    double *heat);

#endif
