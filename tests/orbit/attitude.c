/* Attitude laws against closed forms. All are rotations of unit vectors: 1e-12 is a few thousand
 * roundings, below 1e-6 arc seconds. */
#include "orbit_test.h"

#include "orbit/attitude.h"

static const double TIGHT = 1e-12;

/* A satellite on an inclined orbit, the Sun and an observer somewhere. */
static struct um_orbit_attitude_input input_at(double t)
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

static struct um_orbit_attitude *attitude_of(struct um_context *context,
                                             struct um_orbit_attitude_law law)
{
  struct um_orbit_attitude *attitude = NULL;
  assert_ok(context, um_orbit_attitude_create(context, &law, 1, &attitude));
  return attitude;
}

static struct um_quat attitude_at(struct um_context *context,
                                  const struct um_orbit_attitude *attitude,
                                  const struct um_orbit_attitude_input *input)
{
  struct um_quat q = {NAN, NAN, NAN, NAN};
  assert_ok(context, um_orbit_attitude_at(context, attitude, input, &q));
  assert_near(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, TIGHT);
  return q;
}

/* Axes of the orbital frame in GCRS, from the definition. */
struct lvlh {
  struct um_vec3 x, y, z;
};
static struct lvlh lvlh_of(const struct um_orbit_attitude_input *input)
{
  struct lvlh f;
  f.z = um_vec3_scale(um_vec3_unit(input->r), -1.0);
  f.y = um_vec3_scale(um_vec3_unit(um_vec3_cross(input->r, input->v)), -1.0);
  f.x = um_vec3_cross(f.y, f.z);
  return f;
}

/* q = (cos 30, 0, 0, sin 30) turns the frame by 60 deg about z: the x axis of GCRS reads
 * (cos 60, -sin 60, 0) in body. */
static void fixed(void **state)
{
  struct um_context *context = *state;
  struct um_quat q = {cos(UM_PI / 6.0), 0.0, 0.0, sin(UM_PI / 6.0)};
  struct um_orbit_attitude *attitude = attitude_of(
      context,
      (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_FIXED, .from_tai = -INFINITY, .q = q});
  struct um_orbit_attitude_input input = input_at(1234.0);
  struct um_vec3 body = um_quat_apply(attitude_at(context, attitude, &input), um_vec3(1, 0, 0));
  assert_vec_near(body, um_vec3(0.5, -sqrt(0.75), 0.0), TIGHT);
  assert_near(um_orbit_attitude_rate(attitude, 1e-3), 0.0, 0.0);
  um_orbit_attitude_destroy(&attitude);
  assert_null(attitude);
}

/* z to the geocentre, y against the orbit normal, x ahead; then 3-2-1 angles. The closed form is
 * Wertz 1978, table E-1, 3-2-1 sequence. */
static void lvlh(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_input input = input_at(700.0);
  struct lvlh f = lvlh_of(&input);
  struct um_orbit_attitude *attitude =
      attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_LVLH});
  struct um_quat q = attitude_at(context, attitude, &input);
  assert_vec_near(um_quat_apply(q, um_vec3_unit(input.r)), um_vec3(0, 0, -1), TIGHT);
  assert_vec_near(um_quat_apply(q, f.y), um_vec3(0, 1, 0), TIGHT);
  assert_vec_near(um_quat_apply(q, f.x), um_vec3(1, 0, 0), TIGHT);
  assert_true(um_quat_apply(q, input.v).x > 7400.0); /* x ahead */
  um_orbit_attitude_destroy(&attitude);

  double roll = 0.3, pitch = -0.5, yaw = 1.1;
  attitude =
      attitude_of(context, (struct um_orbit_attitude_law){
                               .kind = UM_ATTITUDE_LVLH, .roll = roll, .pitch = pitch, .yaw = yaw});
  struct um_mat3 got = um_quat_matrix(attitude_at(context, attitude, &input));
  double cr = cos(roll), sr = sin(roll), cp = cos(pitch), sp = sin(pitch), cy = cos(yaw),
         sy = sin(yaw);
  struct um_mat3 euler = {{{cy * cp, sy * cp, -sp},
                           {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
                           {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}}};
  struct um_mat3 want = um_mat3_multiply(euler, um_mat3_from_axes(f.x, f.y, f.z));
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) assert_near(got.m[i][j], want.m[i][j], TIGHT);
  assert_near(um_orbit_attitude_rate(attitude, 1e-3), 1e-3, 0.0);
  um_orbit_attitude_destroy(&attitude);

  input.v = um_vec3(0, 0, 0);
  attitude = attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_LVLH});
  assert_int_equal(um_orbit_attitude_at(context, attitude, &input, &q), UM_ERR_INPUT);
  um_orbit_attitude_destroy(&attitude);
}

/* axis_body lies on the aim; the clock axis lies in the half plane of aim and orbit normal, where
 * it is nearest the normal: clock . (aim x normal) = 0 and clock . normal > 0. */
static void pointing(void **state)
{
  struct um_context *context = *state;
  struct um_vec3 axis = {1.0, 2.0, -0.5}, clock = {0.0, 1.0, 3.0};
  for (int target = 0; target < 2; target++) {
    struct um_orbit_attitude *attitude =
        attitude_of(context, (struct um_orbit_attitude_law){.kind = target ? UM_ATTITUDE_TARGET
                                                                           : UM_ATTITUDE_SUN,
                                                            .axis_body = axis,
                                                            .clock_body = clock});
    for (int k = 0; k < 20; k++) {
      struct um_orbit_attitude_input input = input_at(300.0 * k);
      struct um_vec3 aim = target ? input.observer : input.sun;
      struct um_vec3 normal = um_vec3_unit(um_vec3_cross(input.r, input.v));
      struct um_quat back = um_quat_conjugate(attitude_at(context, attitude, &input));
      assert_vec_near(um_quat_apply(back, um_vec3_unit(axis)), aim, TIGHT);
      /* the part of the clock axis across the pointing axis */
      struct um_vec3 a = um_vec3_unit(axis);
      struct um_vec3 c = um_quat_apply(back, um_vec3_axpy(clock, -um_vec3_dot(clock, a), a));
      assert_near(um_vec3_dot(c, um_vec3_cross(aim, normal)), 0.0, TIGHT);
      assert_true(um_vec3_dot(c, normal) > 0.0);
    }
    um_orbit_attitude_destroy(&attitude);
  }
  /* Sun along the orbit normal: still a rotation that points */
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){
                   .kind = UM_ATTITUDE_SUN, .axis_body = {1, 0, 0}, .clock_body = {0, 0, 1}});
  struct um_orbit_attitude_input input = input_at(0.0);
  input.sun = um_vec3_unit(um_vec3_cross(input.r, input.v));
  struct um_quat q = attitude_at(context, attitude, &input);
  assert_vec_near(um_quat_apply(q, input.sun), um_vec3(1, 0, 0), TIGHT);
  um_orbit_attitude_destroy(&attitude);
}

/* axis_body lies on the geocentre's direction; the clock axis lies in the plane of nadir and Sun,
 * on the Sun's side: clock . (nadir x sun) = 0 and clock . sun > 0. It needs no velocity; with the
 * Sun at the zenith the clock axis goes to the orbit normal, or to GCRS z where there is none. */
static void yaw_steering(void **state)
{
  struct um_context *context = *state;
  struct um_vec3 axis = {0.2, -0.3, 2.0}, clock = {1.0, 0.4, 0.0}, a = um_vec3_unit(axis);
  struct um_vec3 side = um_vec3_unit(um_vec3_axpy(clock, -um_vec3_dot(clock, a), a));
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){
                   .kind = UM_ATTITUDE_YAW_STEERING, .axis_body = axis, .clock_body = clock});
  for (int k = 0; k < 40; k++) {
    struct um_orbit_attitude_input input = input_at(150.0 * k);
    if (k % 2 == 1) input.v = um_vec3(0, 0, 0);
    struct um_vec3 nadir = um_vec3_scale(um_vec3_unit(input.r), -1.0);
    struct um_quat back = um_quat_conjugate(attitude_at(context, attitude, &input));
    struct um_vec3 c = um_quat_apply(back, side);
    assert_vec_near(um_quat_apply(back, a), nadir, TIGHT);
    assert_near(um_vec3_dot(c, um_vec3_cross(nadir, input.sun)), 0.0, TIGHT);
    assert_true(um_vec3_dot(c, input.sun) > 0.0);
  }
  struct um_orbit_attitude_input input = input_at(0.0);
  input.sun = um_vec3_unit(input.r);
  struct um_vec3 normal = um_vec3_unit(um_vec3_cross(input.r, input.v));
  struct um_quat back = um_quat_conjugate(attitude_at(context, attitude, &input));
  assert_vec_near(um_quat_apply(back, side), normal, TIGHT);
  input.v = um_vec3(0, 0, 0);
  back = um_quat_conjugate(attitude_at(context, attitude, &input));
  assert_true(um_quat_apply(back, side).z > 0.1);
  assert_near(um_orbit_attitude_rate(attitude, 1e-3), 0.02, 1e-15);
  um_orbit_attitude_destroy(&attitude);
}

/* Spin about the GCRS z axis with the body's z on it: after t the body x axis stands at the angle
 * phase + 2 pi t / P in the x-y plane. */
static void spin_gcrs(void **state)
{
  struct um_context *context = *state;
  for (int sign = -1; sign <= 1; sign += 2) {
    double period = sign * 213.0, phase = 0.4, at = 5e8;
    struct um_orbit_attitude *attitude =
        attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_SPIN,
                                                            .axis_frame = UM_AXIS_GCRS,
                                                            .axis = {0, 0, 3},
                                                            .axis_body = {0, 0, 2},
                                                            .period = period,
                                                            .phase = phase,
                                                            .at_tai = at});
    for (int k = 0; k < 30; k++) {
      struct um_orbit_attitude_input input = input_at(at + 1e4 * k);
      double angle = phase + 2.0 * UM_PI * (1e4 * k) / period;
      struct um_quat back = um_quat_conjugate(attitude_at(context, attitude, &input));
      /* 1e4 k / P turns: 1e-13 of up to 9000 rad */
      assert_vec_near(um_quat_apply(back, um_vec3(1, 0, 0)), um_vec3(cos(angle), sin(angle), 0.0),
                      1e-9);
      assert_vec_near(um_quat_apply(back, um_vec3(0, 0, 1)), um_vec3(0, 0, 1), TIGHT);
    }
    assert_near(um_orbit_attitude_rate(attitude, 1e-3), 2.0 * UM_PI / 213.0, TIGHT);
    um_orbit_attitude_destroy(&attitude);
  }
}

/* Phase 0 is the smallest rotation: it leaves the common perpendicular of the two axes where it
 * was, and turns by the angle between them. */
static void spin_phase_zero(void **state)
{
  struct um_context *context = *state;
  static const struct um_vec3 axes[] = {
      {1, 0, 0}, {0, 1, 0}, {0.3, -0.7, 0.2}, {-1, 0, 0}, {0, 0, -1}};
  for (size_t i = 0; i < sizeof axes / sizeof axes[0]; i++)
    for (size_t j = 0; j < sizeof axes / sizeof axes[0]; j++) {
      struct um_vec3 e = um_vec3_unit(axes[i]), a = um_vec3_unit(axes[j]);
      struct um_orbit_attitude *attitude =
          attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_SPIN,
                                                              .axis_frame = UM_AXIS_GCRS,
                                                              .axis = axes[i],
                                                              .axis_body = axes[j],
                                                              .period = 100.0,
                                                              .at_tai = 100.0});
      struct um_orbit_attitude_input input = input_at(300.0); /* two whole turns */
      struct um_quat q = attitude_at(context, attitude, &input);
      assert_vec_near(um_quat_apply(q, e), a, TIGHT);
      struct um_vec3 perpendicular = um_vec3_cross(a, e);
      assert_vec_near(um_quat_apply(q, perpendicular), perpendicular, TIGHT);
      double turn = 2.0 * atan2(um_vec3_norm(um_vec3(q.x, q.y, q.z)), fabs(q.w));
      assert_near(turn, um_vec3_angle(a, e), 1e-10);
      um_orbit_attitude_destroy(&attitude);
    }
}

/* ENVISAT: axis 61.86 deg from nadir and 90.69 deg from along-track, on the side opposite to the
 * orbit normal. In LVLH: z = cos 61.86, x = cos 90.69, y = +sqrt(1 - x^2 - z^2) (y is against the
 * normal). The body axis keeps these angles at every instant, while GCRS sees it move. */
static void spin_lvlh(void **state)
{
  struct um_context *context = *state;
  double z = cos(61.86 * UM_DEG), x = cos(90.69 * UM_DEG), y = sqrt(1.0 - x * x - z * z);
  struct um_vec3 axis_body = um_vec3_unit(um_vec3(0.2, 0.9, -0.4));
  struct um_orbit_attitude *attitude =
      attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_SPIN,
                                                          .axis_frame = UM_AXIS_LVLH,
                                                          .axis = {x, y, z},
                                                          .axis_body = axis_body,
                                                          .period = 213.0,
                                                          .phase = 0.2,
                                                          .at_tai = 50.0});
  struct um_vec3 first = {0, 0, 0}, side_before = {0, 0, 0};
  double moved = 0.0;
  for (int k = 0; k < 200; k++) {
    struct um_orbit_attitude_input input = input_at(30.0 * k);
    struct lvlh f = lvlh_of(&input);
    struct um_quat back = um_quat_conjugate(attitude_at(context, attitude, &input));
    struct um_vec3 axis = um_quat_apply(back, axis_body);
    assert_near(um_vec3_angle(axis, um_vec3_scale(input.r, -1.0)) / UM_DEG, 61.86, 1e-10);
    assert_near(um_vec3_angle(axis, f.x) / UM_DEG, 90.69, 1e-10);
    assert_true(um_vec3_dot(axis, um_vec3_cross(input.r, input.v)) < 0.0);
    /* in the orbital frame the body turns by 2 pi 30 / 213 each step about it, right-handed */
    struct um_vec3 side, other;
    um_core_vec3_frame(axis_body, &side, &other);
    struct um_vec3 s = um_mat3_apply(um_mat3_from_axes(f.x, f.y, f.z), um_quat_apply(back, side));
    if (k > 0) {
      struct um_vec3 cross = um_vec3_cross(side_before, s);
      assert_near(atan2(um_vec3_dot(cross, um_vec3(x, y, z)), um_vec3_dot(side_before, s)),
                  2.0 * UM_PI * 30.0 / 213.0, 1e-11);
    }
    side_before = s;
    if (k == 0) first = axis;
    moved = fmax(moved, um_vec3_angle(first, axis));
  }
  /* seen from GCRS it goes round a cone about the orbit normal: twice its half angle of 28 deg */
  assert_near(moved / UM_DEG, 2.0 * acos(y) / UM_DEG, 0.1);
  assert_near(um_orbit_attitude_rate(attitude, 1e-3), 2.0 * UM_PI / 213.0 + 1e-3, TIGHT);
  um_orbit_attitude_destroy(&attitude);
}

/* Axis given in the body frame: q at the reference time, then a turn about an axis that GCRS sees
 * at rest. */
static void spin_body(void **state)
{
  struct um_context *context = *state;
  struct um_quat q0 = um_quat_normalize((struct um_quat){0.3, -0.5, 0.7, 0.2});
  struct um_vec3 axis = um_vec3_unit(um_vec3(1, 1, -2));
  struct um_orbit_attitude *attitude =
      attitude_of(context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_SPIN,
                                                          .axis_frame = UM_AXIS_BODY,
                                                          .q = q0,
                                                          .axis = axis,
                                                          .period = 60.0,
                                                          .at_tai = 10.0});
  struct um_orbit_attitude_input input = input_at(10.0);
  struct um_quat q = attitude_at(context, attitude, &input);
  struct um_vec3 probe = {0.1, -0.4, 0.9};
  assert_vec_near(um_quat_apply(q, probe), um_quat_apply(q0, probe), TIGHT);
  struct um_vec3 inertial = um_quat_apply(um_quat_conjugate(q0), axis);
  for (int k = 0; k < 12; k++) {
    input = input_at(10.0 + 5.0 * k);
    q = attitude_at(context, attitude, &input);
    assert_vec_near(um_quat_apply(q, inertial), axis, TIGHT);
  }
  input = input_at(10.0 + 30.0); /* half a turn: v -> 2 (v.a) a - v */
  q = attitude_at(context, attitude, &input);
  struct um_vec3 v = um_quat_apply(q0, probe);
  assert_vec_near(um_quat_apply(q, probe),
                  um_vec3_sub(um_vec3_scale(axis, 2.0 * um_vec3_dot(v, axis)), v), TIGHT);
  um_orbit_attitude_destroy(&attitude);
}

/* Two rows 90 deg apart about z, one of opposite sign: half way is 45 deg, a third is 30 deg. */
static void table(void **state)
{
  struct um_context *context = *state;
  char path[256], want[512];
  scratch_write("attitude.csv",
                "# q of a turn about z\ntime_utc,q0,q1,q2,q3\n"
                "2016-09-21T20:00:00Z,1,0,0,0\n"
                "2016-09-21T20:00:30Z,-0.70710678118654752,0,0,-0.70710678118654752\n"
                "2016-09-21T20:01:00Z,0,0,0,1\n",
                path);
  double t = utc(context, "2016-09-21T20:00:00Z");
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_TABLE, .table_path = path});
  static const double at[] = {0.0, 10.0, 15.0, 30.0, 45.0, 60.0};
  for (size_t k = 0; k < sizeof at / sizeof at[0]; k++) {
    struct um_orbit_attitude_input input = input_at(t + at[k]);
    double angle = at[k] * 3.0 * UM_DEG;
    struct um_vec3 x = um_quat_apply(attitude_at(context, attitude, &input), um_vec3(1, 0, 0));
    assert_vec_near(x, um_vec3(cos(angle), -sin(angle), 0.0), 1e-8); /* 60 ns of t_tai, 3 deg/s */
  }
  assert_near(um_orbit_attitude_rate(attitude, 1e-3), 3.0 * UM_DEG, 1e-9);
  struct um_orbit_attitude_input outside = input_at(t + 60.5);
  struct um_quat q;
  assert_int_equal(um_orbit_attitude_at(context, attitude, &outside, &q), UM_ERR_INPUT);
  snprintf(want, sizeof want,
           "%s: an attitude is wanted at 2016-09-21T20:01:00.500Z; the table covers "
           "2016-09-21T20:00:00.000Z to 2016-09-21T20:01:00.000Z",
           path);
  assert_string_equal(um_core_message(context), want);
  um_orbit_attitude_destroy(&attitude);
  remove(path);
}

static void refused_table(struct um_context *context, const char *text, double max_gap,
                          const char *message)
{
  char path[256], want[512];
  struct um_orbit_attitude *attitude = NULL;
  scratch_write("attitude_bad.csv", text, path);
  struct um_orbit_attitude_law law = {
      .kind = UM_ATTITUDE_TABLE, .table_path = path, .max_gap = max_gap};
  um_core_message_clear(context);
  assert_int_equal(um_orbit_attitude_create(context, &law, 1, &attitude), UM_ERR_INPUT);
  assert_null(attitude);
  snprintf(want, sizeof want, "%s%s", path, message);
  assert_string_equal(um_core_message(context), want);
  remove(path);
}

static void table_refusals(void **state)
{
  struct um_context *context = *state;
  static const char head[] = "time_utc,q0,q1,q2,q3\n2016-09-21T20:00:00Z,1,0,0,0\n"
                             "2016-09-21T20:00:01Z,1,0,0,0\n2016-09-21T20:00:02Z,1,0,0,0\n"
                             "2016-09-21T20:00:03Z,1,0,0,0\n";
  char text[512];
  snprintf(text, sizeof text, "%s2016-09-21T20:00:14Z,1,0,0,0\n", head);
  refused_table(
      context, text, 0.0,
      ":6: column 'time_utc': a gap of 11.000 s before 2016-09-21T20:00:14Z, at most 10.000 s "
      "is accepted");
  refused_table(
      context, head, 0.5,
      ":3: column 'time_utc': a gap of 1.000 s before 2016-09-21T20:00:01Z, at most 0.500 s "
      "is accepted");
  snprintf(text, sizeof text, "%s2016-09-21T20:00:04Z,1,0.1,0,0\n", head);
  refused_table(context, text, 0.0,
                ":6: column 'q0': the quaternion has norm 1.00499, 1 within 0.001 is accepted");
  snprintf(text, sizeof text, "%s2016-09-21T20:00:03Z,1,0,0,0\n", head);
  refused_table(context, text, 0.0,
                ":6: column 'time_utc': 2016-09-21T20:00:03Z is not after the row before it "
                "(2016-09-21T20:00:03Z); ascending times are accepted");
  refused_table(
      context,
      "time_utc,q0,q1,q2,q3,q4\n2016-09-21T20:00:00Z,1,0,0,0,0\n2016-09-21T20:00:01Z,1,0,0,0,0\n",
      0.0, ": 6 columns; time_utc,q0,q1,q2,q3 are accepted");
}

/* Several laws: each from its time on, the first from the beginning. */
static void schedule(void **state)
{
  struct um_context *context = *state;
  struct um_quat a = {1, 0, 0, 0}, b = {0, 1, 0, 0};
  struct um_orbit_attitude_law laws[2] = {{.kind = UM_ATTITUDE_FIXED, .from_tai = 100.0, .q = a},
                                          {.kind = UM_ATTITUDE_FIXED, .from_tai = 200.0, .q = b}};
  struct um_orbit_attitude *attitude = NULL;
  assert_ok(context, um_orbit_attitude_create(context, laws, 2, &attitude));
  static const struct {
    double t, w;
  } cases[] = {{0.0, 1.0}, {150.0, 1.0}, {199.999, 1.0}, {200.0, 0.0}, {1e9, 0.0}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_attitude_input input = input_at(cases[k].t);
    assert_near(attitude_at(context, attitude, &input).w, cases[k].w, 0.0);
  }
  um_orbit_attitude_destroy(&attitude);
  laws[1].from_tai = 100.0;
  assert_int_equal(um_orbit_attitude_create(context, laws, 2, &attitude), UM_ERR_INPUT);
  assert_null(attitude);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    struct um_orbit_attitude_law law;
    const char *message;
  } cases[] = {
      {{.kind = UM_ATTITUDE_FIXED, .q = {2, 0, 0, 0}},
       "attitude: the quaternion (2, 0, 0, 0) has norm 2, 1 within 0.001 is accepted"},
      {{.kind = UM_ATTITUDE_SUN, .axis_body = {0, 0, 0}, .clock_body = {1, 0, 0}},
       "attitude: axis_body is (0, 0, 0); a direction with finite components, not all zero, is "
       "accepted"},
      {{.kind = UM_ATTITUDE_SUN, .axis_body = {1, 0, 0}, .clock_body = {-2, 0, 0}},
       "attitude: clock_body is parallel to axis_body; an axis beside it is accepted"},
      {{.kind = UM_ATTITUDE_SPIN, .axis = {0, 0, 1}, .axis_body = {0, 0, 1}, .period = 0.0},
       "attitude: spin period 0 s, a finite number other than 0 is accepted"},
      {{.kind = UM_ATTITUDE_SPIN, .axis = {0, NAN, 1}, .axis_body = {0, 0, 1}, .period = 1.0},
       "attitude: the spin axis is (0, nan, 1); a direction with finite components, not all zero, "
       "is "
       "accepted"},
      {{.kind = UM_ATTITUDE_LVLH, .yaw = NAN},
       "attitude: roll, pitch and yaw must be finite numbers"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_attitude *attitude = NULL;
    um_core_message_clear(context);
    assert_int_equal(um_orbit_attitude_create(context, &cases[k].law, 1, &attitude), UM_ERR_INPUT);
    assert_null(attitude);
    assert_string_equal(um_core_message(context), cases[k].message);
  }
  /* TARGET without an observer */
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){
                   .kind = UM_ATTITUDE_TARGET, .axis_body = {1, 0, 0}, .clock_body = {0, 1, 0}});
  struct um_orbit_attitude_input input = input_at(0.0);
  struct um_quat q;
  input.observer = um_vec3(0, 0, 0);
  um_core_message_clear(context);
  assert_int_equal(um_orbit_attitude_at(context, attitude, &input, &q), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "attitude: the law 'target' needs an observer in the scenario");
  um_orbit_attitude_destroy(&attitude);
}

/* Free motion of a body with inertias (1, 1, k) along (t, b, e): Euler's equations
 *   I w' = -w x I w,  R' = R [w]x
 * integrated by Runge and Kutta's fourth order in steps of a 4000th of a turn, from where the law
 * says that the body stands, with the momentum along the law's axis. R takes body to GCRS. */
struct free_body {
  struct um_vec3 w;
  double r[9];
};

static struct free_body slope_of(const struct free_body *s, double k)
{
  struct free_body d;
  struct um_vec3 l = um_vec3(s->w.x, s->w.y, k * s->w.z);
  struct um_vec3 m = um_vec3_cross(l, s->w);
  d.w = um_vec3(m.x, m.y, m.z / k);
  for (int i = 0; i < 3; i++) {
    const double *row = &s->r[3 * i];
    d.r[3 * i] = row[1] * s->w.z - row[2] * s->w.y;
    d.r[3 * i + 1] = row[2] * s->w.x - row[0] * s->w.z;
    d.r[3 * i + 2] = row[0] * s->w.y - row[1] * s->w.x;
  }
  return d;
}

static struct free_body moved(const struct free_body *s, double h, const struct free_body *d)
{
  struct free_body out;
  out.w = um_vec3_axpy(s->w, h, d->w);
  for (int i = 0; i < 9; i++) out.r[i] = s->r[i] + h * d->r[i];
  return out;
}

static void nutation_case(struct um_context *context, double k, double tip, double across,
                          enum um_orbit_axis_frame frame)
{
  struct um_vec3 axis = um_vec3_unit(um_vec3(0.3, -0.5, 0.8)), z = um_vec3(0.0, 0.0, 1.0);
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_SPIN,
                                      .axis_frame = frame,
                                      .axis = frame == UM_AXIS_BODY ? z : axis,
                                      .axis_body = z,
                                      .q = {0.6, 0.48, 0.0, 0.64},
                                      .period = 100.0,
                                      .phase = 0.7,
                                      .at_tai = 50.0,
                                      .nutation = {tip, across},
                                      .inertia_ratio = k};
  struct um_orbit_attitude *a = attitude_of(context, law);
  struct um_orbit_attitude_input now = input_at(50.0);
  struct um_quat q = attitude_at(context, a, &now);
  double theta = hypot(tip, across), own = cos(theta) * (1.0 - k) / k;
  double precession = 2.0 * UM_PI / 100.0 / (1.0 + own); /* L / I_t */
  struct um_vec3 l = frame == UM_AXIS_BODY ? um_quat_apply(um_quat_conjugate(law.q), z) : axis;
  struct um_vec3 in_body = um_vec3_scale(um_quat_apply(q, l), precession);
  assert_near(in_body.z / precession, cos(theta), TIGHT);
  struct free_body s = {.w = um_vec3(in_body.x, in_body.y, in_body.z / k)};
  const struct um_vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int c = 0; c < 3; c++) {
    struct um_vec3 column = um_quat_apply(um_quat_conjugate(q), unit[c]);
    s.r[c] = column.x;
    s.r[3 + c] = column.y;
    s.r[6 + c] = column.z;
  }
  enum { STEPS = 4000 };
  double h = 100.0 / STEPS;
  for (int n = 1; n <= 2 * STEPS; n++) {
    struct free_body k1 = slope_of(&s, k), y2 = moved(&s, 0.5 * h, &k1), k2 = slope_of(&y2, k);
    struct free_body y3 = moved(&s, 0.5 * h, &k2), k3 = slope_of(&y3, k);
    struct free_body y4 = moved(&s, h, &k3), k4 = slope_of(&y4, k);
    s = moved(&s, h / 6.0, &k1);
    s = moved(&s, h / 3.0, &k2);
    s = moved(&s, h / 3.0, &k3);
    s = moved(&s, h / 6.0, &k4);
    if (n % 500 != 0) continue;
    now = input_at(50.0 + n * h);
    q = attitude_at(context, a, &now);
    for (int c = 0; c < 3; c++) {
      struct um_vec3 column = um_quat_apply(um_quat_conjugate(q), unit[c]);
      assert_near(column.x, s.r[c], 1e-9);
      assert_near(column.y, s.r[3 + c], 1e-9);
      assert_near(column.z, s.r[6 + c], 1e-9);
    }
  }
  um_orbit_attitude_destroy(&a);
}

static void nutation(void **state)
{
  struct um_context *context = *state;
  nutation_case(context, 0.14, 0.3, -0.2, UM_AXIS_GCRS); /* a rod about its length */
  nutation_case(context, 1.8, 0.2, 0.1, UM_AXIS_GCRS);   /* a disc about its axis */
  nutation_case(context, 0.5, 1.0, 1.0, UM_AXIS_BODY);
  nutation_case(context, 1.0, 0.0, 0.4, UM_AXIS_GCRS); /* a ball: the tip stands in space */
}

/* The law is the tumble of orbit/tumble.c, from at_tai on (tests/orbit/tumble.c). */
static void tumble(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_TUMBLE,
                                      .q = {0.6, 0.48, 0.0, 0.64},
                                      .inertia = {1.0, 2.0, 2.5, 0.1, 0.0, 0.0},
                                      .rate = {0.01, 0.02, 0.005},
                                      .at_tai = 50.0};
  struct um_orbit_attitude *a = attitude_of(context, law);
  struct um_orbit_attitude_input now = input_at(50.0), later = input_at(50.001);
  struct um_quat q = attitude_at(context, a, &now), after = attitude_at(context, a, &later);
  assert_near(fabs(q.w * 0.6 + q.x * 0.48 + q.z * 0.64), 1.0, TIGHT);
  struct um_quat turn = um_quat_then(um_quat_conjugate(q), after);
  assert_near(2.0 * turn.x / 1e-3, 0.01, 1e-6);
  assert_near(2.0 * turn.y / 1e-3, 0.02, 1e-6);
  assert_near(2.0 * turn.z / 1e-3, 0.005, 1e-6);
  assert_true(um_orbit_attitude_rate(a, 1e-3) >= sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.005 * 0.005));
  um_orbit_attitude_destroy(&a);
}

static double angle_between(struct um_quat a, struct um_quat b)
{
  struct um_quat d = um_quat_then(um_quat_conjugate(a), b);
  return 2.0 * atan2(sqrt(d.x * d.x + d.y * d.y + d.z * d.z), fabs(d.w));
}

#define SLEW_AT 1000.0

/* Two laws with a slew between them, planned. */
static struct um_orbit_attitude *slewing(struct um_context *context,
                                         struct um_orbit_attitude_law first,
                                         struct um_orbit_attitude_law second)
{
  struct um_orbit_attitude_law laws[2] = {first, second};
  struct um_orbit_attitude *a = NULL;
  struct um_orbit_attitude_input in = input_at(SLEW_AT);
  laws[0].from_tai = -INFINITY;
  laws[1].from_tai = SLEW_AT;
  assert_ok(context, um_orbit_attitude_create(context, laws, 2, &a));
  assert_ok(context, um_orbit_attitude_slew(context, a, 1, &in));
  return a;
}

/* 90 deg about z between two fixed attitudes, at most 1 deg/s and 0.1 deg/s^2: 10 s of ramp, 80 s
 * even, 10 s of ramp; 5 deg after 10 s, 45 after 50 s, all about z. */
static void slew_of_limits(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_law first = {.kind = UM_ATTITUDE_FIXED, .q = {1.0, 0.0, 0.0, 0.0}};
  struct um_orbit_attitude_law second = {.kind = UM_ATTITUDE_FIXED,
                                         .q = um_quat_from_axis(um_vec3(0, 0, 1), 0.5 * UM_PI),
                                         .slew_duration = NAN,
                                         .slew_rate = UM_DEG,
                                         .slew_acceleration = 0.1 * UM_DEG};
  struct um_orbit_attitude *a = slewing(context, first, second);
  static const double row[][2] = {{-1.0, 0.0},   {0.0, 0.0},    {5.0, 1.25},
                                  {10.0, 5.0},   {50.0, 45.0},  {90.0, 85.0},
                                  {95.0, 88.75}, {100.0, 90.0}, {200.0, 90.0}};
  for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
    struct um_orbit_attitude_input in = input_at(SLEW_AT + row[i][0]);
    struct um_quat want = um_quat_from_axis(um_vec3(0, 0, 1), row[i][1] * UM_DEG);
    assert_near(angle_between(attitude_at(context, a, &in), want), 0.0, 1e-9);
  }
  assert_near(um_orbit_attitude_rate(a, 1e-3), UM_DEG, TIGHT);
  um_orbit_attitude_destroy(&a);
  /* 4 deg do not reach the rate: 2 sqrt(4/0.1) s, half of it after half the time */
  second.q = um_quat_from_axis(um_vec3(0, 0, 1), 4.0 * UM_DEG);
  a = slewing(context, first, second);
  double whole = 2.0 * sqrt(40.0);
  struct um_orbit_attitude_input in = input_at(SLEW_AT + 0.5 * whole);
  assert_near(angle_between(attitude_at(context, a, &in), first.q), 2.0 * UM_DEG, 1e-9);
  assert_near(um_orbit_attitude_rate(a, 1e-3), 0.1 * UM_DEG * 0.5 * whole, TIGHT);
  um_orbit_attitude_destroy(&a);
}

/* Between laws that move: it starts where the first leaves it, ends where the second has it, and
 * nowhere jumps; without a slew it would. */
static void slew_moving(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_law first = {.kind = UM_ATTITUDE_LVLH, .yaw = 0.3};
  struct um_orbit_attitude_law second = {.kind = UM_ATTITUDE_SUN,
                                         .axis_body = {0, 0, 1},
                                         .clock_body = {0, 1, 0},
                                         .slew_duration = 60.0};
  struct um_orbit_attitude *a = slewing(context, first, second);
  struct um_orbit_attitude *before = attitude_of(context, first), *after;
  second.slew_duration = 0.0;
  after = attitude_of(context, second);
  struct um_orbit_attitude_input in = input_at(SLEW_AT);
  struct um_quat q = attitude_at(context, a, &in);
  double whole = angle_between(q, attitude_at(context, after, &in));
  assert_near(angle_between(q, attitude_at(context, before, &in)), 0.0, 1e-9);
  assert_true(whole > 0.2);
  double most = 0.0, step = 0.25;
  struct um_quat last = q;
  for (double t = -10.0; t < 80.0; t += step) {
    in = input_at(SLEW_AT + t);
    q = attitude_at(context, a, &in);
    if (t > -10.0) most = fmax(most, angle_between(last, q) / step);
    last = q;
  }
  assert_true(most <= um_orbit_attitude_rate(a, 1.05e-3));
  assert_near(most, whole / 30.0, 2.0 * 1.05e-3);
  in = input_at(SLEW_AT + 60.0);
  assert_near(angle_between(attitude_at(context, a, &in), attitude_at(context, after, &in)), 0.0,
              1e-9);
  um_orbit_attitude_destroy(&a);
  um_orbit_attitude_destroy(&before);
  um_orbit_attitude_destroy(&after);
}

static void slew_without_room(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_law laws[3] = {
      {.kind = UM_ATTITUDE_FIXED, .q = {1.0, 0.0, 0.0, 0.0}, .from_tai = -INFINITY},
      {.kind = UM_ATTITUDE_FIXED,
       .q = {0.0, 1.0, 0.0, 0.0},
       .from_tai = 0.0,
       .slew_duration = 60.0},
      {.kind = UM_ATTITUDE_FIXED, .q = {1.0, 0.0, 0.0, 0.0}, .from_tai = 50.0}};
  struct um_orbit_attitude *a = NULL;
  struct um_orbit_attitude_input in = input_at(0.0);
  assert_ok(context, um_orbit_attitude_create(context, laws, 3, &a));
  assert_int_equal(um_orbit_attitude_slew(context, a, 1, &in), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "attitude: the slew of 180 deg takes 60 s, the next law begins after 50 s; "
                      "accepted: a slew that is done by then");
  um_orbit_attitude_destroy(&a);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(fixed, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(lvlh, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(yaw_steering, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(pointing, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(spin_gcrs, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(spin_phase_zero, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(spin_lvlh, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(spin_body, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(nutation, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(tumble, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(slew_of_limits, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(slew_moving, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(slew_without_room, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table_refusals, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(schedule, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
