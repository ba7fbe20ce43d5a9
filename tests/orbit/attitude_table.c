/* Attitude from a table, and what such a file may not say. */
#include "attitude_test.h"

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
  assert_close(um_orbit_attitude_rate(attitude, 1e-3), 3.0 * UM_DEG, 1e-9);
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

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(table, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table_refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
