/* Turned by x of an angle P in a time T, with ramps r of one acceleration at either end and one
 * rate between them (Wie 2008, Space Vehicle Dynamics and Control, 7.3):
 *
 *   x = t^2/(2 r (T - r)),  (t - r/2)/(T - r),  1 - (T - t)^2/(2 r (T - r)).
 *
 * Bound by rate w and acceleration a: r = w/a, T = P/w + r, or, where w is not reached, r =
 * sqrt(P/a), T = 2 r. Of a duration that is given r is half. */
#include "orbit/slew_impl.h"

#include <math.h>

struct um_orbit_slew um_orbit_slew_plan(struct um_quat from, struct um_quat to, double duration,
                                        double rate, double acceleration)
{
  struct um_quat d = um_quat_then(um_quat_conjugate(from), to);
  struct um_vec3 v = um_vec3(d.x, d.y, d.z);
  double sine = um_vec3_norm(v), sign = d.w < 0.0 ? -1.0 : 1.0;
  struct um_orbit_slew s = {.axis = um_vec3(0.0, 0.0, 1.0), .angle = 2.0 * atan2(sine, fabs(d.w))};
  if (sine > 0.0) s.axis = um_vec3_scale(v, sign / sine);
  if (!isnan(duration)) {
    s.duration = duration;
    s.ramp = 0.5 * duration;
  } else if (s.angle * acceleration >= rate * rate) {
    s.ramp = rate / acceleration;
    s.duration = s.angle / rate + s.ramp;
  } else {
    s.ramp = sqrt(s.angle / acceleration);
    s.duration = 2.0 * s.ramp;
  }
  return s;
}

struct um_quat um_orbit_slew_left(const struct um_orbit_slew *s, double since)
{
  double t = since, r = s->ramp, even = s->duration - r, done;
  if (!(t < s->duration)) return (struct um_quat){1.0, 0.0, 0.0, 0.0};
  if (t < r)
    done = t * t / (2.0 * r * even);
  else if (t <= even)
    done = (t - 0.5 * r) / even;
  else
    done = 1.0 - (s->duration - t) * (s->duration - t) / (2.0 * r * even);
  return um_quat_from_axis(s->axis, -(1.0 - done) * s->angle);
}

double um_orbit_slew_fastest(const struct um_orbit_slew *s)
{
  return s->duration > 0.0 ? s->angle / (s->duration - s->ramp) : 0.0;
}
