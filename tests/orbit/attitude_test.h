/* What tests of attitude laws share: a satellite on an inclined orbit, the Sun and an observer
 * somewhere. */
#ifndef UMBRA_TESTS_ORBIT_ATTITUDE_TEST_H
#define UMBRA_TESTS_ORBIT_ATTITUDE_TEST_H

#include "orbit_test.h"

#include "orbit/attitude.h"

static const double TIGHT = 1e-12;

static inline struct um_orbit_attitude_input input_at(double t)
{
  double n = 1.05e-3, u = 0.4 + n * t, i = 98.0 * UM_DEG, node = 0.7;
  struct um_vec3 p = um_vec3(cos(node), sin(node), 0.0);
  struct um_vec3 q = um_vec3(-sin(node) * cos(i), cos(node) * cos(i), sin(i));
  struct um_vec3 out = um_vec3_axpy(um_vec3_scale(p, cos(u)), sin(u), q);
  struct um_vec3 ahead = um_vec3_axpy(um_vec3_scale(q, cos(u)), -sin(u), p);
  return (struct um_orbit_attitude_input){.t_tai = t,
                                          .r = um_vec3_scale(out, 7.14e6),
                                          /* not quite circular: the velocity has a radial part */
                                          .v =
                                              um_vec3_axpy(um_vec3_scale(ahead, 7470.0), 12.0, out),
                                          .sun = um_vec3_unit(um_vec3(-1.0, 0.2, 0.1)),
                                          .observer = um_vec3_unit(um_vec3(0.1, -0.5, -1.0))};
}

static inline struct um_orbit_attitude *attitude_of(struct um_context *context,
                                                    struct um_orbit_attitude_law law)
{
  struct um_orbit_attitude *attitude = NULL;
  assert_ok(context, um_orbit_attitude_create(context, &law, 1, &attitude));
  return attitude;
}

static inline struct um_quat attitude_at(struct um_context *context,
                                         const struct um_orbit_attitude *attitude,
                                         const struct um_orbit_attitude_input *input)
{
  struct um_quat q = {NAN, NAN, NAN, NAN};
  assert_ok(context, um_orbit_attitude_at(context, attitude, input, &q));
  assert_close(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, TIGHT);
  return q;
}

#endif
