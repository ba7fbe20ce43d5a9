/* Attitude laws: quaternion GCRS -> body, passive, scalar first. Closed forms in
 * tests/orbit/attitude.c.
 *
 * The turn of SPIN is counted in the frame of its axis: with an axis in LVLH the period is that of
 * the body relative to the orbital frame. Where r x v vanishes (a fixed point) SUN, TARGET and
 * MAGNETIC take GCRS z for the orbit normal, and the laws that need LVLH are UM_ERR_INPUT. */
#ifndef UMBRA_ORBIT_ATTITUDE_H
#define UMBRA_ORBIT_ATTITUDE_H

#include "core/context.h"
#include "core/vec.h"
#include "orbit/ephemeris.h"

/* What a law may look at, all GCRS. */
struct um_orbit_attitude_input {
  double t_tai;
  struct um_vec3 r, v;                  /* [m], [m/s] */
  struct um_vec3 sun;                   /* unit, from the satellite */
  struct um_vec3 observer;              /* unit, from the satellite; zero when there is none */
  struct um_orbit_ephemeris *ephemeris; /* MAGNETIC: NULL: the series; borrowed */
};

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
  UM_ATTITUDE_TABLE         /* CSV time_utc,q0,q1,q2,q3; slerp; gaps over `max_gap` are errors */
};

enum um_orbit_axis_frame { UM_AXIS_GCRS, UM_AXIS_LVLH, UM_AXIS_BODY };

struct um_orbit_attitude_law {
  enum um_orbit_attitude_kind kind;
  double from_tai;           /* the law holds from here on (-inf: always) */
  struct um_quat q;          /* FIXED: GCRS to body. TUMBLE, and SPIN with axis in the BODY frame:
                                GCRS to body at at_tai */
  double roll, pitch, yaw;   /* LVLH [rad] */
  struct um_vec3 axis_body;  /* SUN, TARGET, YAW_STEERING, SPIN, MAGNETIC: unit */
  struct um_vec3 clock_body; /* all but SPIN: unit, not parallel to axis_body */
  enum um_orbit_axis_frame axis_frame; /* SPIN */
  struct um_vec3 axis; /* SPIN: unit axis in that frame. In GCRS: inertial. In LVLH: the
                          axis co-rotates with the orbital frame at every instant. */
  double period;       /* SPIN, MAGNETIC [s]; > 0 right-handed about +axis; negative turns
                          back; MAGNETIC: 0 does not turn */
  double phase;  /* MAGNETIC [rad]: the same, from clock_body. SPIN [rad]: turn at at_tai; phase 0:
                    with e = axis (in GCRS  resp. LVLH axes) the body is the smallest rotation of
                    that  frame that brings axis_body onto the axis */
  double at_tai; /* SPIN, MAGNETIC, TUMBLE: reference time */
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
  double max_gap;         /* TABLE [s]; <= 0: ten times the median step */
};

struct um_orbit_attitude;

/* laws[n] in order of from_tai (the first is valid from the beginning); copied; tables are read.
 * UM_ERR_INPUT for zero axes, zero period, parallel clock, table faults with file and line. */
enum um_status um_orbit_attitude_create(struct um_context *context,
                                        const struct um_orbit_attitude_law *laws, size_t n,
                                        struct um_orbit_attitude **out);
void um_orbit_attitude_destroy(struct um_orbit_attitude **attitude);
enum um_status um_orbit_attitude_at(struct um_context *context,
                                    const struct um_orbit_attitude *attitude,
                                    const struct um_orbit_attitude_input *input, struct um_quat *q);
/* Plan the slew to law i, 1 <= i < n, from what both laws have at its beginning: input of from_tai.
 * It turns about one axis, the shorter way, relative to the law that it goes to; the law before
 * ends where it begins. Without a plan a law begins at once. UM_ERR_INPUT: it is not done when the
 * next law begins; errors of the laws. */
enum um_status um_orbit_attitude_slew(struct um_context *context,
                                      struct um_orbit_attitude *attitude, size_t i,
                                      const struct um_orbit_attitude_input *input);
/* The smallest rotation of a frame after which `axis_body`, read in the turned frame, is the
 * direction `axis` of the first frame, both unit: about axis_body x axis by the angle between them;
 * any perpendicular serves for opposite directions. SPIN begins with it. */
struct um_quat um_orbit_attitude_smallest_rotation(struct um_vec3 axis_body, struct um_vec3 axis);
/* Largest rate of turn [rad/s] expected of the laws (orbital rate included), for choosing steps. */
double um_orbit_attitude_rate(const struct um_orbit_attitude *attitude, double orbital_rate);

#endif
