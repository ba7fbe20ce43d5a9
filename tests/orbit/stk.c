/* Ephemeris and attitude files of STK: rows by units and frames, every fault's exact message. */
#include "attitude_test.h"

#include "orbit/trajectory.h"

#define EPHEMERIS(unit, frame)                                                                     \
  "stk.v.11.0\n\n# a comment\nBEGIN Ephemeris\nNumberOfEphemerisPoints 2\n"                        \
  "ScenarioEpoch 21 Sep 2016 20:30:00.500\nInterpolationMethod Lagrange\nCentralBody Earth\n"      \
  "CoordinateSystem " frame "\n" unit "\nEphemerisTimePosVel\n\n"
#define ROWS "0 7000.0 1.0 -2.5 0.5 7.5 -0.25\n60.5000001 6985.0 452.0 -17.5 -0.5 7.5 -0.25\n"
#define METRES                                                                                     \
  " 0 7.0e6 1e3 -2.5e3 500 7500 -250\r\n60.5000001 6.985E6 452e3 -17.5e3 -500 7500 -250\r\n"
#define END "END Ephemeris\n"

static enum um_status create(struct um_context *context, const char *text, char path[256],
                             struct um_orbit_trajectory **orbit)
{
  scratch_write("stk", text, path);
  enum um_status status = um_orbit_trajectory_create_table(context, path, NULL, orbit);
  remove(path);
  return status;
}

static void places(void **state)
{
  struct um_context *context = *state;
  static const char *const texts[] = {EPHEMERIS("DistanceUnit Kilometers", "ICRF") ROWS END,
                                      EPHEMERIS("", "ICRF") METRES END,
                                      EPHEMERIS("DistanceUnit Meters", "J2000") METRES END};
  double t = utc(context, "2016-09-21T20:30:00.5Z");
  for (size_t k = 0; k < 3; k++) {
    struct um_orbit_trajectory *orbit = NULL;
    struct um_vec3 r, v;
    double first, last;
    char path[256];
    assert_ok(context, create(context, texts[k], path, &orbit));
    um_orbit_trajectory_span(orbit, &first, &last);
    assert_close(first, t, 1e-6);
    assert_close(last - first, 60.5000001, 2e-7);
    assert_ok(context, um_orbit_trajectory_state(context, orbit, first, &r, &v));
    /* J2000 is turned by the bias of EME2000, 0.8 m (tests/orbit/oem.c) */
    double off = um_vec3_norm(um_vec3_sub(r, um_vec3(7000e3, 1e3, -2.5e3)));
    assert_true(k < 2 ? off < 1e-6 : off > 0.4 && off < 1.2);
    assert_vec_near(v, um_vec3(500.0, 7500.0, -250.0), 2e-3);
    um_orbit_trajectory_destroy(&orbit);
  }
}

/* Frames as STK calls them are those of messages: the first row in GCRS, by both names. */
static void frames(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text;
    enum um_orbit_frame frame;
  } cases[] = {{EPHEMERIS("", "Fixed") METRES END, UM_ORBIT_FRAME_ITRF},
               {EPHEMERIS("", "TEMEOfDate") METRES END, UM_ORBIT_FRAME_TEME},
               {EPHEMERIS("", "TrueOfDate") METRES END, UM_ORBIT_FRAME_TOD},
               {EPHEMERIS("", "meanofdate") METRES END, UM_ORBIT_FRAME_MOD}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct um_orbit_trajectory *orbit = NULL;
    struct um_vec3 r, v, want_r = um_vec3(7000e3, 1e3, -2.5e3), want_v = um_vec3(500, 7500, -250);
    double first, last;
    char path[256];
    assert_ok(context, create(context, cases[k].text, path, &orbit));
    um_orbit_trajectory_span(orbit, &first, &last);
    assert_ok(context, um_orbit_trajectory_state(context, orbit, first, &r, &v));
    assert_ok(context,
              um_orbit_frame_to_gcrs(context, NULL, cases[k].frame, first, &want_r, &want_v));
    assert_vec_near(r, want_r, 1e-6);
    assert_vec_near(v, want_v, 1e-9);
    um_orbit_trajectory_destroy(&orbit);
  }
}

/* 90 deg about z in 30 s: after 10 s the body has turned by 30 toward +y. */
static void turns(void **state)
{
  struct um_context *context = *state;
  static const char text[] =
      "stk.v.4.3\nBEGIN Attitude\nNumberOfAttitudePoints 2\nScenarioEpoch 1 Jan 2017 00:00:00\n"
      "CoordinateAxes ICRF\nAttitudeTimeQuaternions\n0 0 0 0 1\n"
      "30 0 0 0.70710678118654752 0.70710678118654752\nEND Attitude\n";
  char path[256];
  const double angle = 30.0 * UM_DEG;
  scratch_write("stk", text, path);
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_TABLE, .table_path = path});
  struct um_orbit_attitude_input input = input_at(utc(context, "2017-01-01T00:00:10Z"));
  struct um_vec3 x = um_quat_apply(attitude_at(context, attitude, &input), um_vec3(1, 0, 0));
  assert_vec_near(x, um_vec3(cos(angle), -sin(angle), 0.0), 1e-8);
  um_orbit_attitude_destroy(&attitude);
  remove(path);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {EPHEMERIS("", "B1950") METRES END,
       ":9: 'B1950'; accepted: J2000, ICRF, Fixed, TEMEOfDate, TrueOfDate, MeanOfDate"},
      {EPHEMERIS("DistanceUnit Feet", "ICRF") METRES END,
       ":10: 'Feet'; accepted: Meters, Kilometers"},
      {"stk.v.11.0\nBEGIN Attitude\n",
       ":2: 'Attitude'; accepted: Ephemeris; an attitude is for attitude.table"},
      {"stk.v.11.0\nBEGIN Ephemeris\nScenarioEpoch 31 Feb 2016 0:0:0\n",
       ":3: '31 Feb 2016 0:0:0'; accepted: UTC as 1 Jun 2016 12:00:00.000"},
      {"stk.v.11.0\nBEGIN Ephemeris\nCentralBody Moon\n", ":3: 'Moon'; accepted: Earth"},
      {"stk.v.11.0\nBEGIN Ephemeris\nCoordinateSystem ICRF\nEphemerisTimePosVel\n",
       ":4: 'EphemerisTimePosVel'; accepted: ScenarioEpoch before it"},
      {"stk.v.11.0\nBEGIN Ephemeris\nScenarioEpoch 1 Jan 2017 00:00:00\nEphemerisTimePosVel\n",
       ":4: 'EphemerisTimePosVel'; accepted: CoordinateSystem before it"},
      {"stk.v.11.0\nBEGIN Ephemeris\nEphemerisTimePos\n",
       ":3: 'EphemerisTimePos'; accepted: EphemerisTimePosVel"},
      {EPHEMERIS("", "ICRF") METRES, ":15: no END behind rows: the file may be cut short"},
      {EPHEMERIS("", "ICRF") "0 7e6 0 0 0 seven 0\n" END,
       ":13: 'seven'; accepted: seconds, 3 of the place, 3 of the velocity"},
      {EPHEMERIS("", "ICRF") "0 7e6 0 0\n" END,
       ":13: '0'; accepted: seconds, 3 of the place, 3 of the velocity"},
      {EPHEMERIS("", "ICRF") "0 7e6 0 0 0 7e3 0\n0 7e6 0 0 0 7e3 0\n" END,
       ":14: 73836.500000000 is not after the row before it; ascending times are accepted"},
      {EPHEMERIS("", "ICRF") "0 7e3 0 0 0 7e3 0\n" END,
       ":13: the position is 7 km from the geocentre; accepted: 6000 to 1e+09 km"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_trajectory *orbit = NULL;
    char path[256];
    assert_int_equal(create(context, cases[k].text, path, &orbit), UM_ERR_INPUT);
    assert_string_equal(um_core_message(context) + strlen(path), cases[k].message);
    assert_null(orbit);
    um_core_message_clear(context);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(places, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(frames, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(turns, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
