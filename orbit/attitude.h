/* Attitude laws: quaternion GCRS -> body, passive, scalar first. Closed forms in
 * tests/orbit/attitude.c.
 *
 * The turn of SPIN is counted in the frame of its axis: with an axis in LVLH the period is that of
 * the body relative to the orbital frame. Where r x v vanishes (a fixed point) SUN, TARGET and
 * MAGNETIC take GCRS z for the orbit normal, and the laws that need LVLH are UM_ERR_INPUT. */
#ifndef UMBRA_ORBIT_ATTITUDE_H
#define UMBRA_ORBIT_ATTITUDE_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/attitude_law.h"
#include "orbit/ephemeris.h"

/* What a law may look at, all GCRS. */
struct um_orbit_attitude_input {
  double t_tai;                         /* [s] */
  struct um_vec3 r, v;                  /* [m], [m/s] */
  struct um_vec3 sun;                   /* unit, from the satellite [1] */
  struct um_vec3 observer;              /* unit, from the satellite; zero when there is none [1] */
  struct um_orbit_ephemeris *ephemeris; /* MAGNETIC: NULL: the series; borrowed */
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
/* Largest rate of turn [rad/s] expected of the laws (orbital rate included), for choosing steps. */
double um_orbit_attitude_rate(const struct um_orbit_attitude *attitude, double orbital_rate);

#endif
