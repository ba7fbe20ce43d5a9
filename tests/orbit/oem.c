/* Ephemeris messages: rows by every time scale and frame, several segments, every fault's exact
 * message. */
#include "orbit_test.h"

#include "orbit/trajectory.h"

#define HEAD "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2016-265T00:00:00\nORIGINATOR = X\n"
#define META(frame, scale)                                                                         \
  "\nMETA_START\nOBJECT_NAME = A SAT\nCENTER_NAME = EARTH\nREF_FRAME = " frame                     \
  "\nTIME_SYSTEM = " scale "\nSTART_TIME = 2016-09-21T20:31:00\nMETA_STOP\n"
#define ROW_1 "2016-09-21T20:31:00.000 7000.0 1.0 -2.5 0.5 7.5 -0.25\n"
#define ROW_2 "2016-09-21T20:32:00.500 6985.0 452.0 -17.5 -0.5 7.5 -0.25 1e-3 0 0\n"

static struct um_orbit_trajectory *read(struct um_context *context, const char *text)
{
  struct um_orbit_trajectory *orbit = NULL;
  char path[256];
  scratch_write("oem", text, path);
  enum um_status status = um_orbit_trajectory_create_table(context, path, &orbit);
  remove(path);
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
  return orbit;
}

/* The first row's place and velocity stand at t; without a bias of the frame to the digit. */
static void expect_first(struct um_context *context, const char *text, double t, double tolerance)
{
  struct um_orbit_trajectory *orbit = read(context, text);
  struct um_vec3 r, v;
  double first, last;
  um_orbit_trajectory_span(orbit, &first, &last);
  assert_close(first, t, 1e-6);
  assert_close(last, t + 60.5, 1e-6);
  assert_ok(context, um_orbit_trajectory_state(context, orbit, first, &r, &v));
  assert_vec_near(r, um_vec3(7000e3, 1e3, -2.5e3), tolerance);
  assert_vec_near(v, um_vec3(500.0, 7500.0, -250.0), 1e-3 * tolerance + 1e-9);
  um_orbit_trajectory_destroy(&orbit);
}

/* TAI was 36 s ahead of UTC in 2016, TT is 32.184 s ahead of TAI, GPS 19 s behind it. */
static void scales(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, "2016-09-21T20:31:00Z");
  expect_first(context, HEAD META("GCRF", "UTC") ROW_1 ROW_2, t, 1e-9);
  expect_first(context, HEAD META("ICRF", "TAI") ROW_1 ROW_2, t - 36.0, 1e-9);
  expect_first(context,
               HEAD "META_START\nREF_FRAME=GCRF\nTIME_SYSTEM= UTC\nMETA_STOP\n" ROW_1 ROW_2, t,
               1e-9);
  expect_first(context, HEAD META("GCRF", "TT") ROW_1 ROW_2, t - 36.0 - 32.184, 1e-9);
  expect_first(context, HEAD META("GCRF", "GPS") ROW_1 ROW_2, t - 17.0, 1e-9);
  /* of CNES, MJD 57652 is 2016-09-21; blank lines and comments */
  expect_first(
      context,
      "CIC_OEM_VERS = 1.0\n\nMETA_START\n\nCOMMENT x\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\n"
      "META_STOP\n57652 73860.000 7000.0 1.0 -2.5 0.5 7.5 -0.25\r\n"
      "57652 73920.500 6985.0 452.0 -17.5 -0.5 7.5 -0.25\n",
      t, 1e-9);
}

/* EME2000: IERS TN36, 5.6: of its bias against GCRS are -41.775 mas in longitude (times sin of the
 * obliquity: -16.617 mas of the pole in x), -6.819 mas of the pole in y, -14.6 mas of the equinox.
 */
static void frame_bias(void **state)
{
  struct um_context *context = *state;
  const double xi = -16.617e-3 * UM_ARCSEC, eta = -6.819e-3 * UM_ARCSEC,
               alpha = -14.6e-3 * UM_ARCSEC;
  struct um_orbit_trajectory *orbit = read(context, HEAD META("EME2000", "UTC") ROW_1 ROW_2);
  struct um_vec3 r, v, e = um_vec3(7000e3, 1e3, -2.5e3);
  assert_ok(context, um_orbit_trajectory_state(context, orbit, utc(context, "2016-09-21T20:31:00Z"),
                                               &r, &v));
  /* first order: r_GCRS = (1 - b x) r, of rotations by eta, -xi, -alpha about the axes */
  struct um_vec3 b = um_vec3(-eta, xi, alpha);
  assert_vec_near(r, um_vec3_add(e, um_vec3_cross(b, e)), 2e-3);
  assert_true(um_vec3_norm(um_vec3_sub(r, e)) > 0.4);
  um_orbit_trajectory_destroy(&orbit);
}

/* Segments one behind the other; the row at which both meet is one; a covariance is passed over. */
static void segments(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit =
      read(context, HEAD META("GCRF", "UTC") ROW_1 ROW_2
           "COVARIANCE_START\nEPOCH = 2016-09-21T20:31:00\n"
           "1.0\n0.1 1.0\nCOVARIANCE_STOP\n" META(
               "GCRF", "TAI") "2016-09-21T20:32:36.500 6985.0 452.0 -17.5 -0.5 7.5 -0.25\n"
                              "2016-265T20:33:36.500 6940.0 900.0 -30.0 -1.0 7.4 -0.2\n");
  double first, last;
  um_orbit_trajectory_span(orbit, &first, &last);
  assert_close(last - first, 120.5, 1e-6);
  um_orbit_trajectory_destroy(&orbit);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {HEAD META("ITRF2000", "UTC") ROW_1 ROW_2,
       ":8: REF_FRAME: 'ITRF2000'; accepted: GCRF, ICRF, EME2000"},
      {HEAD META("GCRF", "TDB") ROW_1 ROW_2, ":9: TIME_SYSTEM: 'TDB'; accepted: UTC, TAI, TT, GPS"},
      {HEAD "META_START\nCENTER_NAME = MOON\n", ":5: CENTER_NAME: 'MOON'; accepted: EARTH"},
      {HEAD "META_START\nREF_FRAME = GCRF\nMETA_STOP\n", ":6: the segment has no TIME_SYSTEM"},
      {HEAD "META_START\nREF_FRAME GCRF\n",
       ":5: a line between META_START and META_STOP: 'REF_FRAME'; accepted: KEYWORD = value"},
      {HEAD "META_START\nTIME_SYSTEM=UTC\nMETA_STOP\n", ":6: the segment has no REF_FRAME"},
      {HEAD META("GCRF", "UTC") ROW_1, ": 1 rows, at least 2 are accepted"},
      {HEAD META("GCRF", "UTC") ROW_1 ROW_1,
       ":13: 2016-09-21T20:31:00.000 is not after the row before it; ascending times are accepted"},
      {HEAD META("GCRF", "UTC") "2016-09-21T20:31:00 7000 1 2\n",
       ":12: 4 fields; accepted: a time, 3 of the place, 3 of the velocity"},
      {HEAD META("GCRF", "UTC") "2016-09-21T20:31:00 7000 1 2 0 seven 0\n",
       ":12: a row: 'seven'; accepted: a number"},
      {HEAD META("GCRF", "UTC") "2016-09-21T20:31:00 700 1 2 0 7 0\n",
       ":12: the position is 700.004 km from the geocentre; accepted: 6000 to 1e+09 km"},
      {HEAD META("GCRF", "UTC") "2016-09-21T20:31:00 7000 1 2 0 3e5 0\n",
       ":12: the speed is 300000 km/s; accepted: less than light's"},
      {HEAD META("GCRF", "GPS") "2016-09-31T20:31:00 7000 1 2 0 7 0\n",
       ":12: time: '2016-09-31T20:31:00'; accepted: a time of GPS like 2016-09-21T20:33:00 from "
       "1960 "
       "to 2100"},
      {"CIC_OEM_VERS = 1.0\nMETA_START\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\nMETA_STOP\n57652.5 0 "
       "7000 1 2 0 7 0\n",
       ":6: time: '57652.5'; accepted: a modified Julian day and seconds of it, 57652 73862.0"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_trajectory *orbit = NULL;
    char path[256];
    scratch_write("oem", cases[k].text, path);
    assert_int_equal(um_orbit_trajectory_create_table(context, path, &orbit), UM_ERR_INPUT);
    remove(path);
    assert_string_equal(um_core_message(context) + strlen(path), cases[k].message);
    assert_null(orbit);
    um_core_message_clear(context);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(scales, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(frame_bias, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(segments, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
