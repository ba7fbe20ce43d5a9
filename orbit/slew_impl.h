/* A turn about one axis, from where a law leaves the body to where the next one has it. Private to
 * orbit/. */
#ifndef UMBRA_ORBIT_SLEW_IMPL_H
#define UMBRA_ORBIT_SLEW_IMPL_H

#include "base/core/vec.h"

struct um_orbit_slew {
  struct um_vec3 axis; /* unit, reads the same in both */
  double angle;        /* [rad], 0 to pi */
  double duration;     /* [s]; 0: there is none */
  double ramp;         /* of it at either end, at one acceleration [s] */
};

/* From one attitude to another, the shorter way. duration [s], or NaN where rate [rad/s] and
 * acceleration [rad/s^2] bound it. */
struct um_orbit_slew um_orbit_slew_plan(struct um_quat from, struct um_quat to, double duration,
                                        double rate, double acceleration);
/* What is still between the body and the law that it turns to, `since` the beginning [s]: law then
 * this is where it stands. */
struct um_quat um_orbit_slew_left(const struct um_orbit_slew *slew, double since);
double um_orbit_slew_fastest(const struct um_orbit_slew *slew); /* [rad/s] */

#endif
