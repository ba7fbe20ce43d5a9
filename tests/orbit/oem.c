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
  enum um_status status = um_orbit_trajectory_create_table(context, path, NULL, &orbit);
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

static const struct um_orbit_earth_orientation eop = {
    .ut1_utc = -0.2678, .xp = 0.2366 * UM_ARCSEC, .yp = 0.3513 * UM_ARCSEC};

#define OEM  "<oem id=\"CCSDS_OEM_VERS\" version=\"2.0\">"
#define BODY "<header><CREATION_DATE>2016-265T00:00:00</CREATION_DATE></header>\n<body>\n"
#define XML_META(frame, scale)                                                                     \
  "<segment><metadata>\n<COMMENT>a = b</COMMENT><CENTER_NAME> "                                    \
  "EARTH\n</CENTER_NAME><REF_FRAME>" frame "</REF_FRAME>\n<TIME_SYSTEM>" scale                     \
  "</TIME_SYSTEM></metadata>\n<data>\n"
#define XML_1                                                                                      \
  "<stateVector><EPOCH>2016-09-21T20:31:00.000</EPOCH>\n<X units=\"km\">7000.0</X><Y>1.0</Y>"      \
  "<Z>-2.5</Z>\n<X_DOT units=\"km/s\">0.5</X_DOT><Y_DOT>7.5</Y_DOT><Z_DOT>-0.25</Z_DOT>"           \
  "</stateVector>\n"
#define XML_2                                                                                      \
  "<stateVector><EPOCH>2016-265T20:32:00.500</EPOCH><Z_DOT>-0.25</Z_DOT><Y_DOT>7.5</Y_DOT>"        \
  "<X_DOT>-0.5</X_DOT><X_DDOT>1</X_DDOT><Z>-17.5</Z><Y>452.0</Y><X>6985.0</X></stateVector>\n"
#define XML_END "</data></segment>\n"
#define XML_COVARIANCE                                                                             \
  "<covarianceMatrix><EPOCH>2016-09-21T20:31:00</EPOCH><CX_X>1</CX_X></covarianceMatrix>"
#define OEM_END "</body></oem>\n"

/* A message in XML says what its other form does: alone, within `ndm` beside others and with a
 * prefix; two segments, and two messages, go on from one another. */
static void xml(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, "2016-09-21T20:31:00Z");
  static const char again[] =
      "<stateVector><EPOCH>2016-09-21T20:32:36.500</EPOCH><X>6985</X><Y>452</Y><Z>-17.5</Z>"
      "<X_DOT>-0.5</X_DOT><Y_DOT>7.5</Y_DOT><Z_DOT>-0.25</Z_DOT></stateVector>";
  char text[4096];
  expect_first(context,
               "<?xml version=\"1.0\"?>\n" OEM BODY XML_META("GCRF", "UTC")
                   XML_1 XML_2 XML_COVARIANCE XML_END OEM_END,
               t, 1e-9);
  expect_first(
      context,
      "\xEF\xBB\xBF<!-- a > b --><ndm><omm><body><EPOCH>1</EPOCH></body></omm>" OEM BODY XML_META(
          "ITRF", "TAI") XML_END XML_META("ICRF", "TAI") XML_1 XML_2 XML_END OEM_END "</ndm>",
      t - 36.0, 1e-9);
  expect_first(
      context,
      "<n:oem xmlns:n=\"urn:x\" version=\"2.0\"><n:body><n:segment><n:metadata><n:REF_FRAME>"
      "GCRF</n:REF_FRAME><n:TIME_SYSTEM>GPS</n:TIME_SYSTEM></n:metadata><n:data>" XML_1 XML_2
      "</n:data></n:segment></n:body></n:oem>",
      t - 17.0, 1e-9);
  for (int apart = 0; apart < 2; apart++) {
    snprintf(text, sizeof text, "<ndm>" OEM "<body>" XML_META("GCRF", "UTC") "%s%s%s%s%s",
             XML_1 XML_2 XML_END, apart != 0 ? OEM_END OEM "<body>" : "", XML_META("GCRF", "TAI"),
             again, XML_END OEM_END "</ndm>");
    expect_first(context, text, t, 1e-9);
  }
}

#define STEP 8.0 /* [s] */

/* One row of a flight, as a frame has it: the velocity is the slope of the polynomial through
 * places there at five times, so that no formula of the reader's is in it. It leaves 1e-6 m/s of
 * the orbit, and of times, which are known to 0.06 us, 0.1 mm/s. */
static size_t put_row(struct um_context *context, const struct um_orbit_trajectory *flight,
                      bool turns, double t, char *out, size_t size)
{
  struct um_vec3 x[5];
  char clock[32];
  for (int k = 0; k < 5; k++) {
    struct um_mat3 m;
    double at = t + STEP * (k - 2);
    assert_ok(context, um_orbit_trajectory_state(context, flight, at, &x[k], NULL));
    assert_ok(context,
              um_orbit_frame_from_gcrs(context, &eop,
                                       turns ? UM_ORBIT_FRAME_ITRF : UM_ORBIT_FRAME_TEME, at, &m));
    x[k] = um_mat3_apply(m, x[k]);
  }
  struct um_vec3 near = um_vec3_sub(x[3], x[1]), far = um_vec3_sub(x[4], x[0]);
  struct um_vec3 v =
      um_vec3_scale(um_vec3_axpy(um_vec3_scale(near, 8.0), -1.0, far), 1.0 / (12.0 * STEP));
  um_orbit_time_format(t, clock);
  return (size_t)snprintf(out, size, "%s %.9f %.9f %.9f %.12f %.12f %.12f\n", clock, x[2].x * 1e-3,
                          x[2].y * 1e-3, x[2].z * 1e-3, v.x * 1e-3, v.y * 1e-3, v.z * 1e-3);
}

/* A flight written in frames that turn, and read back: rows as they were, velocities but for the
 * slow turn of the pole and the equinox (30 um/s), and between rows as a cubic has it. */
static void round_trip(void **state)
{
  struct um_context *context = *state;
  const struct um_orbit_kepler kepler = {
      utc(context, "2016-09-06T00:00:00Z"), 7.2e6, 1e-3, 1.7, 0.4, 1.0, 0.3};
  struct um_orbit_trajectory *flight = NULL, *back = NULL;
  assert_ok(context, um_orbit_trajectory_create_kepler(context, &kepler, &flight));
  for (int turns = 0; turns < 2; turns++) {
    char text[4096], path[256];
    size_t n =
        (size_t)snprintf(text, sizeof text, "%s",
                         turns != 0 ? HEAD META("ITRF2014", "UTC") : HEAD META("TEME", "UTC"));
    for (int k = 0; k < 11; k++)
      n += put_row(context, flight, turns != 0, kepler.epoch_tai + 30.0 * k, text + n,
                   sizeof text - n);
    scratch_write("oem", text, path);
    assert_ok(context, um_orbit_trajectory_create_table(context, path, &eop, &back));
    remove(path);
    for (int k = 0; k <= 20; k++) {
      struct um_vec3 r[2], v[2];
      double t = kepler.epoch_tai + 15.0 * k;
      assert_ok(context, um_orbit_trajectory_state(context, flight, t, &r[0], &v[0]));
      assert_ok(context, um_orbit_trajectory_state(context, back, t, &r[1], &v[1]));
      assert_vec_near(r[1], r[0], k % 2 == 0 ? 1e-5 : 0.03);
      assert_vec_near(v[1], v[0], 1e-4);
    }
    um_orbit_trajectory_destroy(&back);
  }
  um_orbit_trajectory_destroy(&flight);
}

/* Rows outside of the table of the Earth's orientation. */
static void beyond_finals(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_earth_orientation table = {0};
  struct um_orbit_trajectory *orbit = NULL;
  char path[256], oem[256];
  scratch_write("finals",
                "16 9 6 57637.00 I  0.236620 0.000030  0.351290 0.000020  I-0.2677940 0.0000090\n"
                "16 9 8 57639.00 I  0.236620 0.000030  0.351290 0.000020  I-0.2677940 0.0000090\n",
                path);
  assert_ok(context, um_orbit_finals_read(context, path, &table.finals));
  remove(path);
  scratch_write("oem", HEAD META("ITRF", "UTC") ROW_1 ROW_2, oem);
  assert_int_equal(um_orbit_trajectory_create_table(context, oem, &table, &orbit), UM_ERR_INPUT);
  remove(oem);
  assert_string_equal(um_core_message(context) + strlen(oem),
                      ":12: Earth orientation is wanted at 2016-09-21T20:31:00.000Z; the finals "
                      "table covers 2016-09-06T00:00:00.000Z to 2016-09-08T00:00:00.000Z");
  um_orbit_finals_destroy(&table.finals);
}

#define DEEP "<a><a><a><a><a><a><a><a>"
#define LONG "0123456789012345678901234567890123456789012345678"

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {HEAD META("GTOD", "UTC") ROW_1 ROW_2,
       ":8: REF_FRAME: 'GTOD'; accepted: GCRF, ICRF, EME2000, ITRF, TEME, TOD, MOD"},
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
      {OEM BODY XML_META("GTOD", "UTC"),
       ":5: REF_FRAME: 'GTOD'; accepted: GCRF, ICRF, EME2000, ITRF, TEME, TOD, MOD"},
      {OEM BODY XML_META("GCRF", "TDB"), ":6: TIME_SYSTEM: 'TDB'; accepted: UTC, TAI, TT, GPS"},
      {OEM BODY "<segment><data>",
       ":3: a segment without metadata; accepted: metadata before data"},
      {OEM BODY XML_META("GCRF", "UTC") XML_END "<segment>\n<data>",
       ":10: a segment without metadata; accepted: metadata before data"},
      {OEM BODY XML_META("GCRF", "UTC") XML_1 "\n" XML_1 XML_END,
       ":12: 2016-09-21T20:31:00.000 is not after the row before it; ascending times are accepted"},
      {OEM BODY XML_META("GCRF", "UTC") "<stateVector>\n<X units=\"m\">7e6</X>",
       ":9: X: 'm'; accepted: km"},
      {OEM BODY XML_META("GCRF", "UTC") "<stateVector>\n<EPOCH>COMMENT</EPOCH>",
       ":9: EPOCH: 'COMMENT'; accepted: a time like 2016-09-21T20:33:00"},
      {OEM BODY XML_META("GCRF", "UTC") "<stateVector>\n<X>1</X>\n<X>1</X>",
       ":10: X stands twice in a stateVector"},
      {OEM BODY XML_META("GCRF",
                         "UTC") "\n<stateVector>\n<EPOCH>2016-09-21T20:31:00</EPOCH><X>1</X>\n"
                                "</stateVector>",
       ":9: the stateVector that begins here has no Y"},
      {OEM BODY XML_META("GCRF", "UTC") "<stateVector>\n<X>1</X></stateVector>",
       ":8: the stateVector that begins here has no EPOCH"},
      {OEM BODY XML_META("GCRF", "UTC") XML_1, ":11: not XML as it should be: no element found"},
      {OEM BODY XML_META("GCRF", "UTC") XML_1 XML_END OEM_END, ": 1 rows, at least 2 are accepted"},
      {"<ndm>\n<aem/></ndm>", ": no element oem; accepted: navigation messages (NDM/XML) with one"},
      {"<!DOCTYPE oem [<!ENTITY a \"1\">]>\n" OEM,
       ":1: a document type; accepted: navigation messages without"},
      {"<ndm>" DEEP DEEP DEEP DEEP, ":1: more than 32 elements in one another; accepted: no more"},
      {OEM BODY "<segment><metadata>\n<REF_FRAME>" LONG LONG LONG "</REF_FRAME>",
       ":4: REF_FRAME is longer than 127 bytes; accepted: no more"},
      {"CIC_OEM_VERS = 1.0\nMETA_START\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\nMETA_STOP\n57652.5 0 "
       "7000 1 2 0 7 0\n",
       ":6: time: '57652.5'; accepted: a modified Julian day and seconds of it, 57652 73862.0"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_trajectory *orbit = NULL;
    char path[256];
    scratch_write("oem", cases[k].text, path);
    assert_int_equal(um_orbit_trajectory_create_table(context, path, NULL, &orbit), UM_ERR_INPUT);
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
      cmocka_unit_test_setup_teardown(xml, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(round_trip, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(beyond_finals, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
