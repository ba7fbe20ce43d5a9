/* What an attitude law must state. */
#include "orbit/attitude_law_impl.h"

#include <math.h>

#include "base/core/constants.h"

static enum um_status unit_axis(struct um_context *context, const char *name, struct um_vec3 *axis)
{
  double norm = um_vec3_norm(*axis);
  if (!(norm > 0.0 && norm < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: %s is (%g, %g, %g); a direction with finite components, not all "
                        "zero, is accepted",
                        name, axis->x, axis->y, axis->z);
  *axis = um_vec3_scale(*axis, 1.0 / norm);
  return UM_OK;
}

static enum um_status unit_quaternion(struct um_context *context, struct um_quat *q)
{
  double norm = sqrt(q->w * q->w + q->x * q->x + q->y * q->y + q->z * q->z);
  if (!(fabs(norm - 1.0) <= 1e-3))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "attitude: the quaternion (%g, %g, %g, %g) has norm %.6g, 1 within 0.001 is "
        "accepted",
        q->w, q->x, q->y, q->z, norm);
  *q = um_quat_normalize(*q);
  return UM_OK;
}

static enum um_status pointing_check(struct um_context *context, struct um_orbit_attitude_law *law)
{
  UM_TRY(unit_axis(context, "axis_body", &law->axis_body));
  UM_TRY(unit_axis(context, "clock_body", &law->clock_body));
  double across = um_vec3_norm(um_vec3_cross(law->axis_body, law->clock_body));
  if (!(across > 1e-6))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "attitude: clock_body is parallel to axis_body; an axis beside it is accepted");
  return UM_OK;
}

static enum um_status spin_check(struct um_context *context, struct um_orbit_attitude_law *law)
{
  UM_TRY(unit_axis(context, "the spin axis", &law->axis));
  if (law->axis_frame == UM_AXIS_BODY)
    UM_TRY(unit_quaternion(context, &law->q));
  else
    UM_TRY(unit_axis(context, "axis_body", &law->axis_body));
  if (!(fabs(law->period) > 0.0 && fabs(law->period) < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: spin period %g s, a finite number other than 0 is accepted",
                        law->period);
  if (!isfinite(law->phase + law->at_tai))
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: spin phase and reference time must be finite numbers");
  if (law->inertia_ratio == 0.0) law->inertia_ratio = 1.0;
  if (!(law->inertia_ratio > 0.0 && law->inertia_ratio <= 2.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: inertia ratio %g; accepted: above 0 to 2, as bodies have it",
                        law->inertia_ratio);
  if (!(hypot(law->nutation[0], law->nutation[1]) < 0.5 * UM_PI))
    return um_core_fail(context, UM_ERR_INPUT, "attitude: nutation of %g deg; accepted: below 90",
                        hypot(law->nutation[0], law->nutation[1]) / UM_DEG);
  return UM_OK;
}

static enum um_status magnetic_check(struct um_context *context, struct um_orbit_attitude_law *law)
{
  UM_TRY(pointing_check(context, law));
  if (isfinite(law->period + law->phase + law->at_tai)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "attitude: period, phase and reference time must be finite numbers");
}

static enum um_status tumble_check(struct um_context *context, struct um_orbit_attitude_law *law)
{
  UM_TRY(unit_quaternion(context, &law->q));
  if (isfinite(law->at_tai)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "attitude: the reference time of a tumble must be a finite number");
}

enum um_status um_orbit_attitude_law_check(struct um_context *context,
                                           struct um_orbit_attitude_law *law)
{
  switch (law->kind) {
  case UM_ATTITUDE_FIXED:
    return unit_quaternion(context, &law->q);
  case UM_ATTITUDE_LVLH:
    if (isfinite(law->roll + law->pitch + law->yaw)) return UM_OK;
    return um_core_fail(context, UM_ERR_INPUT,
                        "attitude: roll, pitch and yaw must be finite numbers");
  case UM_ATTITUDE_SUN:
  case UM_ATTITUDE_TARGET:
  case UM_ATTITUDE_YAW_STEERING:
    return pointing_check(context, law);
  case UM_ATTITUDE_SPIN:
    return spin_check(context, law);
  case UM_ATTITUDE_MAGNETIC:
    return magnetic_check(context, law);
  case UM_ATTITUDE_TUMBLE:
    return tumble_check(context, law);
  case UM_ATTITUDE_TABLE:
    break;
  }
  return UM_OK;
}
