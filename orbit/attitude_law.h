/* What an attitude law states. */
#ifndef UMBRA_ORBIT_ATTITUDE_LAW_H
#define UMBRA_ORBIT_ATTITUDE_LAW_H

#include "base/core/vec.h"

struct um_orbit_earth_orientation; /* orbit/finals.h */

enum um_orbit_attitude_kind {
  UM_ATTITUDE_FIXED,  /* q constant in GCRS */
  UM_ATTITUDE_LVLH,   /* z to the geocentre, y against the orbit normal, x completing; then roll,
                         pitch, yaw: body = Rx(roll) Ry(pitch) Rz(yaw) applied to LVLH (3-2-1) */
  UM_ATTITUDE_SUN,    /* axis_body points at the Sun; second axis: the body axis `clock_body` is as
                         near the orbit normal as possible */
  UM_ATTITUDE_TARGET, /* the same toward the observer */
  UM_ATTITUDE_YAW_STEERING, /* axis_body points at the geocentre, clock_body is as near the Sun as
                               possible: it lies in the plane of nadir and Sun */
  UM_ATTITUDE_SPIN,         /* axis_body is along the inertial axis, turning at 2 pi / period */
  UM_ATTITUDE_MAGNETIC,     /* axis_body is along the Earth's magnetic field, as a magnet without
                               damping or lag would have it; clock_body is as near the orbit normal
                               as possible, and where a period is given the body turns about the
                               axis from there */
  UM_ATTITUDE_TUMBLE,       /* free motion of a body with three moments of inertia */
  UM_ATTITUDE_TABLE         /* CSV time_utc,q0,q1,q2,q3 or a message; slerp; gaps over `max_gap`
                               are errors */
};

enum um_orbit_axis_frame { UM_AXIS_GCRS, UM_AXIS_LVLH, UM_AXIS_BODY };

struct um_orbit_attitude_law {
  enum um_orbit_attitude_kind kind;
  double from_tai;           /* the law holds from here on (-inf: always) [s] */
  struct um_quat q;          /* FIXED: GCRS to body. TUMBLE, and SPIN with axis in the BODY frame:
                                GCRS to body at at_tai */
  double roll, pitch, yaw;   /* LVLH [rad] */
  struct um_vec3 axis_body;  /* SUN, TARGET, YAW_STEERING, SPIN, MAGNETIC: unit [1] */
  struct um_vec3 clock_body; /* all but SPIN: unit, not parallel to axis_body [1] */
  enum um_orbit_axis_frame axis_frame; /* SPIN */
  struct um_vec3 axis; /* SPIN: unit axis in that frame. In GCRS: inertial. In LVLH: the
                          axis co-rotates with the orbital frame at every instant. [1] */
  double period;       /* SPIN, MAGNETIC [s]; > 0 right-handed about +axis; negative turns
                          back; MAGNETIC: 0 does not turn */
  double phase;  /* MAGNETIC [rad]: the same, from clock_body. SPIN [rad]: turn at at_tai; phase 0:
                    with e = axis (in GCRS  resp. LVLH axes) the body is the smallest rotation of
                    that  frame that brings axis_body onto the axis */
  double at_tai; /* SPIN, MAGNETIC, TUMBLE: reference time [s] */
  /* SPIN of a body that is symmetric about axis_body: nutation[2] tips axis_body from the angular
   * momentum, which lies along `axis`, about two axes across it at at_tai [rad]; inertia about
   * axis_body over that across it [1], 0 as 1 */
  double nutation[2], inertia_ratio;
  double inertia[6];   /* TUMBLE: xx, yy, zz, xy, xz, yz in body axes [any unit] */
  struct um_vec3 rate; /* TUMBLE: at at_tai, in body axes [rad/s] */
  /* How the body comes from the law before to this one, from from_tai on: in slew_duration [s], or,
   * where that is NaN, under a rate [rad/s] and an acceleration [rad/s^2]; 0: at once */
  double slew_duration, slew_rate, slew_acceleration;
  const char *table_path; /* TABLE */
  /* TABLE: of messages in frames that turn with the Earth; NULL: UT1 is UTC, the pole at zero.
   * Borrowed until the attitude is made */
  const struct um_orbit_earth_orientation *orientation;
  double max_gap; /* TABLE [s]; <= 0: ten times the median step */
};

#endif
