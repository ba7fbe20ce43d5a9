/* Attitude laws against closed forms. All are rotations of unit vectors: 1e-12 is a few thousand
 * roundings, below 1e-6 arc seconds. */
#include "attitude_test.h"

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
  assert_close(um_orbit_attitude_rate(attitude, 1e-3), 0.0, 0.0);
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
    for (int j = 0; j < 3; j++) assert_close(got.m[i][j], want.m[i][j], TIGHT);
  assert_close(um_orbit_attitude_rate(attitude, 1e-3), 1e-3, 0.0);
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
      assert_close(um_vec3_dot(c, um_vec3_cross(aim, normal)), 0.0, TIGHT);
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
    assert_close(um_vec3_dot(c, um_vec3_cross(nadir, input.sun)), 0.0, TIGHT);
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
  assert_close(um_orbit_attitude_rate(attitude, 1e-3), 0.02, 1e-15);
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
    assert_close(um_orbit_attitude_rate(attitude, 1e-3), 2.0 * UM_PI / 213.0, TIGHT);
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
      assert_close(turn, um_vec3_angle(a, e), 1e-10);
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
    assert_close(um_vec3_angle(axis, um_vec3_scale(input.r, -1.0)) / UM_DEG, 61.86, 1e-10);
    assert_close(um_vec3_angle(axis, f.x) / UM_DEG, 90.69, 1e-10);
    assert_true(um_vec3_dot(axis, um_vec3_cross(input.r, input.v)) < 0.0);
    /* in the orbital frame the body turns by 2 pi 30 / 213 each step about it, right-handed */
    struct um_vec3 side, other;
    um_core_vec3_frame(axis_body, &side, &other);
    struct um_vec3 s = um_mat3_apply(um_mat3_from_axes(f.x, f.y, f.z), um_quat_apply(back, side));
    if (k > 0) {
      struct um_vec3 cross = um_vec3_cross(side_before, s);
      assert_close(atan2(um_vec3_dot(cross, um_vec3(x, y, z)), um_vec3_dot(side_before, s)),
                   2.0 * UM_PI * 30.0 / 213.0, 1e-11);
    }
    side_before = s;
    if (k == 0) first = axis;
    moved = fmax(moved, um_vec3_angle(first, axis));
  }
  /* seen from GCRS it goes round a cone about the orbit normal: twice its half angle of 28 deg */
  assert_close(moved / UM_DEG, 2.0 * acos(y) / UM_DEG, 0.1);
  assert_close(um_orbit_attitude_rate(attitude, 1e-3), 2.0 * UM_PI / 213.0 + 1e-3, TIGHT);
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
    assert_close(attitude_at(context, attitude, &input).w, cases[k].w, 0.0);
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
      cmocka_unit_test_setup_teardown(schedule, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
