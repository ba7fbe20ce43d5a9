/* Attitude laws. q is GCRS to body, passive, scalar first.
 *
 *   LVLH    z = -r/|r|, y = -(r x v)/|r x v|, x = y x z; body = Rx(roll) Ry(pitch) Rz(yaw) LVLH
 *   SUN     axis_body along the Sun, clock_body in the half plane of Sun and orbit normal
 *   TARGET  the same with the observer in place of the Sun
 *   YAW_STEERING  axis_body along -r, clock_body in the half plane of -r and Sun
 *   MAGNETIC  axis_body along the field, clock_body in the half plane of field and orbit normal,
 *           then turned about the axis by phase + 2 pi (t - t0) / period
 *   SPIN    frame F -> smallest rotation that lays axis_body on the axis -> turn about it by
 *           phase + 2 pi (t - t0) / period; F is GCRS, or LVLH of the instant
 *   TUMBLE  tumble.c
 * Reference: Wertz 1978, Spacecraft Attitude Determination and Control, appendix E. */
#include "orbit/attitude.h"

#include "base/core/constants.h"
#include "orbit/attitude_law_impl.h"
#include "orbit/attitude_table_impl.h"
#include "orbit/frames.h"
#include "orbit/magnetic_field.h"
#include "orbit/slew_impl.h"
#include "orbit/tumble_impl.h"

/* Close above a station the direction to it turns faster than the orbit does: v / h against v / r,
 * 17 times at 400 km. */
static const double TARGET_RATE_FACTOR = 20.0;

/* The yaw turns fastest where the Sun stands nearest to zenith or nadir, at n / tan(beta) for a
 * solar angle beta to the orbital plane: 19 times the orbit at 3 deg. Nearer to the plane it flips
 * faster than the grid of the loads follows; what faces nadir does not notice. */
static const double YAW_RATE_FACTOR = 20.0;

/* The line of a dipole turns by 3 times the orbit's rate over the magnetic equator, that of the
 * true field somewhat faster. */
static const double MAGNETIC_RATE_FACTOR = 4.0;

struct law {
  struct um_orbit_attitude_law law; /* axes are unit; table_path is not kept */
  struct um_orbit_attitude_table table;
  struct um_orbit_tumble tumble;
  struct um_orbit_slew slew;
};

struct um_orbit_attitude {
  struct um_context *context; /* owns the memory */
  size_t n;
  struct law *law; /* shape [n], in order of from_tai */
};

static enum um_status law_make(struct um_context *context, struct law *law)
{
  UM_TRY(um_orbit_attitude_law_check(context, &law->law));
  if (law->law.kind == UM_ATTITUDE_TUMBLE)
    return um_orbit_tumble_make(context, law->law.inertia, law->law.rate, law->law.q, &law->tumble);
  if (law->law.kind != UM_ATTITUDE_TABLE) return UM_OK;
  return um_orbit_attitude_table_read(context, law->law.table_path, law->law.orientation,
                                      law->law.max_gap, &law->table);
}

enum um_status um_orbit_attitude_create(struct um_context *context,
                                        const struct um_orbit_attitude_law *laws, size_t n,
                                        struct um_orbit_attitude **out)
{
  enum um_status status;
  struct um_orbit_attitude *attitude = NULL;
  *out = NULL;
  if (n == 0)
    return um_core_fail(context, UM_ERR_INPUT, "attitude: no law given, at least one is accepted");
  UM_CHECK(um_core_allocate(context, 1, sizeof *attitude, &attitude));
  attitude->context = context;
  UM_CHECK(um_core_allocate(context, n, sizeof *attitude->law, &attitude->law));
  attitude->n = n;
  for (size_t i = 0; i < n; i++) {
    attitude->law[i].law = laws[i];
    if (i > 0 && !(laws[i].from_tai > laws[i - 1].from_tai && laws[i].from_tai < INFINITY)) {
      status = um_core_fail(context, UM_ERR_INPUT,
                            "attitude: law %zu does not begin after the law before it; ascending "
                            "times are accepted",
                            i + 1);
      goto done;
    }
    UM_CHECK(law_make(context, &attitude->law[i]));
    attitude->law[i].law.table_path = NULL; /* borrowed from the caller, not needed any more */
  }
done:
  if (status != UM_OK) um_orbit_attitude_destroy(&attitude);
  *out = attitude;
  return status;
}

void um_orbit_attitude_destroy(struct um_orbit_attitude **attitude)
{
  if (!attitude || !*attitude) return;
  struct um_context *context = (*attitude)->context;
  for (size_t i = 0; i < (*attitude)->n; i++)
    um_orbit_attitude_table_clear(context, &(*attitude)->law[i].table);
  UM_FREE(context, (*attitude)->law, *attitude);
  *attitude = NULL;
}

/* Quaternion GCRS -> LVLH of the instant. */
static enum um_status lvlh(struct um_context *context, const struct um_orbit_attitude_input *input,
                           struct um_quat *q)
{
  struct um_vec3 normal = um_vec3_cross(input->r, input->v);
  if (!(um_vec3_norm(normal) > 0.0))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "attitude: the orbital frame needs a satellite that moves across its radius");
  struct um_vec3 z = um_vec3_scale(um_vec3_unit(input->r), -1.0);
  struct um_vec3 y = um_vec3_scale(um_vec3_unit(normal), -1.0);
  *q = um_core_quat_from_matrix(um_mat3_from_axes(um_vec3_cross(y, z), y, z));
  return UM_OK;
}

/* body = Rx(roll) Ry(pitch) Rz(yaw) applied to LVLH: yaw first. */
static struct um_quat roll_pitch_yaw(const struct um_orbit_attitude_law *law)
{
  struct um_quat yaw = um_quat_from_axis(um_vec3(0, 0, 1), law->yaw);
  struct um_quat pitch = um_quat_from_axis(um_vec3(0, 1, 0), law->pitch);
  struct um_quat roll = um_quat_from_axis(um_vec3(1, 0, 0), law->roll);
  return um_quat_then(um_quat_then(yaw, pitch), roll);
}

/* Part of v across the unit vector axis, unit; `fallback` (in turn) when there is none. */
static struct um_vec3 across(struct um_vec3 v, struct um_vec3 axis, struct um_vec3 default_value)
{
  struct um_vec3 part = um_vec3_axpy(v, -um_vec3_dot(v, axis), axis);
  if (um_vec3_norm(part) > 1e-9) return um_vec3_unit(part);
  part = um_vec3_axpy(default_value, -um_vec3_dot(default_value, axis), axis);
  if (um_vec3_norm(part) > 1e-9) return um_vec3_unit(part);
  struct um_vec3 b;
  um_core_vec3_frame(axis, &part, &b);
  return part;
}

/* Lay axis_body on `aim` and clock_body along n, which is across it. With the triads
 *   B = [a, c, a x c] in body, G = [aim, n, aim x n] in GCRS:  R = B^T G  (rows are axes) */
static struct um_quat two_axes(const struct um_orbit_attitude_law *law, struct um_vec3 aim,
                               struct um_vec3 n)
{
  struct um_vec3 a = law->axis_body, c = across(law->clock_body, a, a);
  struct um_mat3 body = um_mat3_from_axes(a, c, um_vec3_cross(a, c));
  struct um_mat3 gcrs = um_mat3_from_axes(aim, n, um_vec3_cross(aim, n));
  return um_core_quat_from_matrix(um_mat3_multiply(um_mat3_transpose(body), gcrs));
}

/* Unit normal of the orbit; GCRS z for a point at rest. */
static struct um_vec3 orbit_normal(const struct um_orbit_attitude_input *input)
{
  struct um_vec3 normal = um_vec3_cross(input->r, input->v);
  double size = um_vec3_norm(normal);
  return size > 0.0 ? um_vec3_scale(normal, 1.0 / size) : um_vec3(0, 0, 1);
}

/* clock_body toward the orbit normal (the satellite's radius when that is along the aim). */
static struct um_quat pointing(const struct um_orbit_attitude_law *law,
                               const struct um_orbit_attitude_input *input, struct um_vec3 aim)
{
  return two_axes(law, aim, across(orbit_normal(input), aim, um_vec3_unit(input->r)));
}

/* clock_body toward the Sun (the orbit normal when the Sun is at zenith or nadir). */
static struct um_quat yaw_steering(const struct um_orbit_attitude_law *law,
                                   const struct um_orbit_attitude_input *input)
{
  struct um_vec3 nadir = um_vec3_scale(um_vec3_unit(input->r), -1.0);
  return two_axes(law, nadir, across(input->sun, nadir, orbit_normal(input)));
}

/* Turn about the axis at a time; whole turns are taken off before the angle is formed, so that long
 * spans keep their digits. */
static double turn_at(const struct um_orbit_attitude_law *law, double t_tai)
{
  double turns = (t_tai - law->at_tai) / law->period;
  return law->phase + 2.0 * UM_PI * (turns - floor(turns));
}

/* The orientation of the Earth without UT1-UTC and the motion of the pole: 15 arcsec. */
static enum um_status magnetic(struct um_context *context, const struct um_orbit_attitude_law *law,
                               const struct um_orbit_attitude_input *input, struct um_quat *q)
{
  const struct um_orbit_earth_orientation none = {.ephemeris = input->ephemeris};
  struct um_mat3 m;
  UM_TRY(um_orbit_frames_gcrs_to_itrf(context, &none, input->t_tai, &m));
  struct um_vec3 field =
      um_orbit_magnetic_field(input->t_tai, um_mat3_apply(m, input->r), UM_MAGNETIC_DEGREE);
  struct um_vec3 aim = um_vec3_unit(um_mat3_apply(um_mat3_transpose(m), field));
  double angle = law->period != 0.0 ? turn_at(law, input->t_tai) : law->phase;
  *q = um_quat_then(pointing(law, input, aim), um_quat_from_axis(law->axis_body, angle));
  return UM_OK;
}

/* Free motion of a body that is symmetric about e, from a frame in which e is along the angular
 * momentum: precession by phi about it, tilt by theta about an axis across it that the body sees at
 * at_tai, and rotation by psi about the body's own e,
 *   phi' = L/I_t,  psi' = phi' cos(theta) (1 - k)/k,  k = I_e/I_t
 * (Goldstein, Classical Mechanics, 3rd ed., 5.6). The period is that of phi + psi, so that a small
 * tilt turns as without it. */
static struct um_quat nutating(const struct um_orbit_attitude_law *law, struct um_vec3 e,
                               double turn)
{
  struct um_vec3 t, b;
  double theta = hypot(law->nutation[0], law->nutation[1]), k = law->inertia_ratio;
  if (!(theta > 0.0)) return um_quat_from_axis(e, turn);
  double own = cos(theta) * (1.0 - k) / k, phi = (turn - law->phase) / (1.0 + own);
  um_core_vec3_frame(e, &t, &b);
  struct um_vec3 across =
      um_vec3_axpy(um_vec3_scale(t, law->nutation[0] / theta), law->nutation[1] / theta, b);
  struct um_quat q = um_quat_then(um_quat_from_axis(e, phi), um_quat_from_axis(across, theta));
  return um_quat_then(q, um_quat_from_axis(e, law->phase + own * phi));
}

static enum um_status spin(struct um_context *context, const struct um_orbit_attitude_law *law,
                           const struct um_orbit_attitude_input *input, struct um_quat *q)
{
  bool tilted = law->nutation[0] != 0.0 || law->nutation[1] != 0.0;
  /* phi is no whole number of turns when their sum is one */
  double angle = tilted ? law->phase + 2.0 * UM_PI * (input->t_tai - law->at_tai) / law->period
                        : turn_at(law, input->t_tai);
  struct um_quat base = {1.0, 0.0, 0.0, 0.0};
  if (law->axis_frame == UM_AXIS_BODY) {
    *q = um_quat_then(law->q, nutating(law, law->axis, angle));
    return UM_OK;
  }
  if (law->axis_frame == UM_AXIS_LVLH) UM_TRY(lvlh(context, input, &base));
  base = um_quat_then(base, um_core_quat_between(law->axis_body, law->axis));
  *q = um_quat_then(base, nutating(law, law->axis_body, angle));
  return UM_OK;
}

static const struct law *law_at(const struct um_orbit_attitude *attitude, double t_tai)
{
  size_t i = 0;
  while (i + 1 < attitude->n && attitude->law[i + 1].law.from_tai <= t_tai) i++;
  return &attitude->law[i];
}

/* As the law has it, without its slew. */
static enum um_status attitude_of(struct um_context *context, const struct law *now,
                                  const struct um_orbit_attitude_input *input, struct um_quat *q)
{
  const struct um_orbit_attitude_law *law = &now->law;
  switch (law->kind) {
  case UM_ATTITUDE_FIXED:
    *q = law->q;
    return UM_OK;
  case UM_ATTITUDE_LVLH:
    UM_TRY(lvlh(context, input, q));
    *q = um_quat_then(*q, roll_pitch_yaw(law));
    return UM_OK;
  case UM_ATTITUDE_SUN:
    *q = pointing(law, input, input->sun);
    return UM_OK;
  case UM_ATTITUDE_TARGET:
    if (!(um_vec3_norm(input->observer) > 0.5))
      return um_core_fail(context, UM_ERR_INPUT,
                          "attitude: the law 'target' needs an observer in the scenario");
    *q = pointing(law, input, input->observer);
    return UM_OK;
  case UM_ATTITUDE_YAW_STEERING:
    *q = yaw_steering(law, input);
    return UM_OK;
  case UM_ATTITUDE_SPIN:
    return spin(context, law, input, q);
  case UM_ATTITUDE_MAGNETIC:
    return magnetic(context, law, input, q);
  case UM_ATTITUDE_TUMBLE:
    *q = um_orbit_tumble_at(&now->tumble, input->t_tai - law->at_tai, NULL);
    return UM_OK;
  case UM_ATTITUDE_TABLE:
    break;
  }
  return um_orbit_attitude_table_at(context, &now->table, input->t_tai, q);
}

enum um_status um_orbit_attitude_at(struct um_context *context,
                                    const struct um_orbit_attitude *attitude,
                                    const struct um_orbit_attitude_input *input, struct um_quat *q)
{
  const struct law *now = law_at(attitude, input->t_tai);
  UM_TRY(attitude_of(context, now, input, q));
  double since = input->t_tai - now->law.from_tai;
  if (now->slew.duration > 0.0 && since < now->slew.duration)
    *q = um_quat_then(*q, um_orbit_slew_left(&now->slew, since));
  return UM_OK;
}

enum um_status um_orbit_attitude_slew(struct um_context *context,
                                      struct um_orbit_attitude *attitude, size_t i,
                                      const struct um_orbit_attitude_input *input)
{
  struct law *now = &attitude->law[i];
  const struct um_orbit_attitude_law *law = &now->law;
  struct um_quat before, after;
  if (law->slew_duration == 0.0) return UM_OK;
  UM_TRY(attitude_of(context, now - 1, input, &before));
  UM_TRY(attitude_of(context, now, input, &after));
  struct um_orbit_slew slew =
      um_orbit_slew_plan(before, after, law->slew_duration, law->slew_rate, law->slew_acceleration);
  double room = i + 1 < attitude->n ? now[1].law.from_tai - law->from_tai : (double)INFINITY;
  if (!(slew.duration <= room))
    return um_core_fail(
        context, UM_ERR_INPUT,
        "attitude: the slew of %.4g deg takes %g s, the next law begins after %g s; "
        "accepted: a slew that is done by then",
        slew.angle / UM_DEG, slew.duration, room);
  now->slew = slew;
  return UM_OK;
}

/* How fast directions turn in a body that nutates [rad/s]: with s a fixed direction in body axes,
 * s' = -w x s, what is linear over a time h is off by h^2/8 |s''|, and
 *
 *   |s''| <= |w|^2 + |w'|,   |w|^2 = phi'^2 + psi'^2 + 2 phi' psi' cos(theta),
 *                            |w'| = |phi' psi'| sin(theta),
 *
 * so that it turns as a steady spin of the root of that. */
static double spin_rate(const struct um_orbit_attitude_law *law)
{
  double theta = hypot(law->nutation[0], law->nutation[1]), k = law->inertia_ratio;
  double turn = 2.0 * UM_PI / fabs(law->period);
  if (!(theta > 0.0)) return turn;
  double own = cos(theta) * (1.0 - k) / k, square = 1.0 + own * own + 2.0 * own * cos(theta);
  double phi = turn / fabs(1.0 + own);
  return phi * sqrt(square + fabs(own) * sin(theta));
}

static double law_rate(const struct law *now, double orbital_rate)
{
  const struct um_orbit_attitude_law *law = &now->law;
  switch (law->kind) {
  case UM_ATTITUDE_FIXED:
    return 0.0;
  case UM_ATTITUDE_LVLH:
  case UM_ATTITUDE_SUN:
    return orbital_rate;
  case UM_ATTITUDE_TARGET:
    return TARGET_RATE_FACTOR * orbital_rate;
  case UM_ATTITUDE_YAW_STEERING:
    return YAW_RATE_FACTOR * orbital_rate;
  case UM_ATTITUDE_MAGNETIC:
    return MAGNETIC_RATE_FACTOR * orbital_rate +
           (law->period != 0.0 ? 2.0 * UM_PI / fabs(law->period) : 0.0);
  case UM_ATTITUDE_TUMBLE:
    return um_orbit_tumble_fastest(&now->tumble);
  case UM_ATTITUDE_SPIN:
    return spin_rate(law) + (law->axis_frame == UM_AXIS_LVLH ? orbital_rate : 0.0);
  case UM_ATTITUDE_TABLE:
    break;
  }
  return um_orbit_attitude_table_rate(&now->table);
}

double um_orbit_attitude_rate(const struct um_orbit_attitude *attitude, double orbital_rate)
{
  double fastest = 0.0;
  for (size_t i = 0; i < attitude->n; i++)
    fastest = fmax(fastest, law_rate(&attitude->law[i], orbital_rate) +
                                um_orbit_slew_fastest(&attitude->law[i].slew));
  return fastest;
}
