/* Slews between attitude laws: planned within limits of rate and acceleration, or between laws that
 * move. */
#include "attitude_test.h"

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
    assert_close(angle_between(attitude_at(context, a, &in), want), 0.0, 1e-9);
  }
  assert_close(um_orbit_attitude_rate(a, 1e-3), UM_DEG, TIGHT);
  um_orbit_attitude_destroy(&a);
  /* 4 deg do not reach the rate: 2 sqrt(4/0.1) s, half of it after half the time */
  second.q = um_quat_from_axis(um_vec3(0, 0, 1), 4.0 * UM_DEG);
  a = slewing(context, first, second);
  double whole = 2.0 * sqrt(40.0);
  struct um_orbit_attitude_input in = input_at(SLEW_AT + 0.5 * whole);
  assert_close(angle_between(attitude_at(context, a, &in), first.q), 2.0 * UM_DEG, 1e-9);
  assert_close(um_orbit_attitude_rate(a, 1e-3), 0.1 * UM_DEG * 0.5 * whole, TIGHT);
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
  assert_close(angle_between(q, attitude_at(context, before, &in)), 0.0, 1e-9);
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
  assert_close(most, whole / 30.0, 2.0 * 1.05e-3);
  in = input_at(SLEW_AT + 60.0);
  assert_close(angle_between(attitude_at(context, a, &in), attitude_at(context, after, &in)), 0.0,
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
      cmocka_unit_test_setup_teardown(slew_of_limits, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(slew_moving, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(slew_without_room, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
