/* Attitude messages: every direction, order and frame says the same turn; every fault's message. */
#include "attitude_test.h"

#include "orbit/frames.h"

#define HEAD "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2016-265T00:00:00\nORIGINATOR = X\n"
#define META(a, b, dir, type)                                                                      \
  "META_START\nOBJECT_NAME = A SAT\nREF_FRAME_A = " a "\nREF_FRAME_B = " b "\nATTITUDE_DIR = " dir \
  "\nTIME_SYSTEM = UTC\nATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = " type                       \
  "\nMETA_STOP\nDATA_START\n"
/* 0 and 90 deg about z, the scalar first and last, and the other way round */
#define FIRST                                                                                      \
  "2016-09-21T20:00:00 1 0 0 0\n2016-265T20:00:30 0.70710678118654752 0 0 0.70710678118654752\n"
#define LAST                                                                                       \
  "2016-09-21T20:00:00 0 0 0 1\n2016-09-21T20:00:30 0 0 0.70710678118654752 0.70710678118654752\n"
#define BACK                                                                                       \
  "2016-09-21T20:00:00 1 0 0 0\n2016-09-21T20:00:30 0.70710678118654752 0 0 "                      \
  "-0.70710678118654752\n"
#define STOP "DATA_STOP\n"

#define XML(version, a, b, meta)                                                                   \
  "<aem id=\"CCSDS_AEM_VERS\" version=\"" version                                                  \
  "\"><header/><body><segment><metadata>\n<REF_FRAME_A>" a "</REF_FRAME_A><REF_FRAME_B>" b         \
  "</REF_FRAME_B><TIME_SYSTEM>UTC</TIME_SYSTEM>\n<ATTITUDE_TYPE>QUATERNION</ATTITUDE_TYPE>" meta   \
  "</metadata><data>\n"
/* components in one order and the other, by the names of either version */
#define XML_ROWS                                                                                   \
  "<attitudeState><quaternionEphemeris><EPOCH>2016-09-21T20:00:00</EPOCH><quaternion><Q1>0</Q1>"   \
  "<Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion></quaternionEphemeris></attitudeState>\n"            \
  "<attitudeState><quaternionState><EPOCH>2016-265T20:00:30</EPOCH><quaternion>"                   \
  "<QC>0.70710678118654752</QC><Q1>0</Q1><Q2>0</Q2><Q3>0.70710678118654752</Q3></quaternion>"      \
  "</quaternionState></attitudeState>\n"
#define XML_END "</data></segment></body></aem>\n"

/* Where the inertial x axis stands in the body after 10 s of the turn. */
static struct um_vec3 x_axis(struct um_context *context, const char *text)
{
  char path[256];
  scratch_write("aem", text, path);
  struct um_orbit_attitude *attitude = attitude_of(
      context, (struct um_orbit_attitude_law){.kind = UM_ATTITUDE_TABLE, .table_path = path});
  struct um_orbit_attitude_input input = input_at(utc(context, "2016-09-21T20:00:10Z"));
  struct um_vec3 x = um_quat_apply(attitude_at(context, attitude, &input), um_vec3(1, 0, 0));
  um_orbit_attitude_destroy(&attitude);
  remove(path);
  return x;
}

/* 30 deg about z: the body turns toward +y, and sees the axis go toward -y. */
static void turns(void **state)
{
  struct um_context *context = *state;
  static const char *const texts[] = {
      HEAD META("GCRF", "SC_BODY_1", "A2B", "FIRST") FIRST STOP,
      HEAD META("ICRF", "SC_BODY_1", "A2B", "LAST") LAST STOP,
      HEAD META("SC_BODY_1", "GCRF", "B2A", "FIRST") FIRST STOP,
      HEAD META("GCRF", "SC_BODY_1", "B2A", "FIRST") BACK STOP,
      HEAD META("SC_BODY_1", "GCRF", "A2B", "FIRST") BACK STOP,
      /* version 2 */
      "CCSDS_AEM_VERS = 2.0\nMETA_START\nREF_FRAME_A = GCRF\nREF_FRAME_B = SC_BODY_1\n"
      "TIME_SYSTEM = UTC\nATTITUDE_TYPE = QUATERNION\nMETA_STOP\nDATA_START\n" LAST STOP,
      /* of CNES; MJD 57652 is 2016-09-21 */
      "CIC_AEM_VERS = 1.0\n" META("ICRF", "SATELLITE_FRAME", "A2B",
                                  "FIRST") "57652 72000.0 1 0 0 0\n57652 72030.0 "
                                           "0.70710678118654752 0 0 0.70710678118654752\n",
      XML("2.0", "GCRF", "SC_BODY_1", "") XML_ROWS XML_END,
      "<ndm>" XML("1.0", "GCRF", "SC_BODY_1",
                  "<ATTITUDE_DIR>A2B</ATTITUDE_DIR><QUATERNION_TYPE>FIRST</QUATERNION_TYPE>")
          XML_ROWS XML_END "</ndm>",
  };
  const double angle = 30.0 * UM_DEG;
  assert_int_equal(sizeof texts / sizeof *texts, 9);
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++)
    assert_vec_near(x_axis(context, texts[k]), um_vec3(cos(angle), -sin(angle), 0.0), 1e-8);
}

/* The bias of EME2000, -14.6 mas of the equinox and -16.617 mas of the pole (IERS TN36, 5.6): the x
 * axis of GCRS in EME2000 is (1, 14.6 mas, -16.617 mas). */
static void frame_bias(void **state)
{
  struct um_context *context = *state;
  const double angle = 30.0 * UM_DEG, y = 14.6e-3 * UM_ARCSEC, z = -16.617e-3 * UM_ARCSEC;
  struct um_vec3 x = x_axis(context, HEAD META("EME2000", "SC_BODY_1", "A2B", "FIRST") FIRST STOP);
  assert_vec_near(x, um_vec3(cos(angle) + y * sin(angle), y * cos(angle) - sin(angle), z),
                  2e-10 + 1e-8);
  assert_close(x.z, z, 2e-10); /* no turn about z moves it */
}

/* A body that stands still in ITRF turns with the Earth: at each row it is where the Earth is, and
 * between two that are 30 s apart 1e-8 off of it at most, the turn about the pole being even. The
 * first row's quaternion is not the second's: 90 deg about z come first. */
static void turning_frame(void **state)
{
  struct um_context *context = *state;
  static const struct um_orbit_earth_orientation eop = {
      .ut1_utc = -0.2678, .xp = 0.2366 * UM_ARCSEC, .yp = 0.3513 * UM_ARCSEC};
  static const char text[] =
      HEAD META("ITRF", "SC_BODY_1", "A2B",
                "LAST") "2016-09-21T20:00:00 0 0 0.70710678118654752 0.70710678118654752\n"
                        "2016-09-21T20:00:30 0 0 0.70710678118654752 0.70710678118654752\n" STOP;
  char path[256];
  scratch_write("aem", text, path);
  struct um_orbit_attitude *attitude =
      attitude_of(context, (struct um_orbit_attitude_law){
                               .kind = UM_ATTITUDE_TABLE, .table_path = path, .orientation = &eop});
  remove(path);
  for (int k = 0; k < 3; k++) {
    struct um_mat3 earth;
    double t = utc(context, "2016-09-21T20:00:00Z") + 15.0 * k;
    struct um_orbit_attitude_input input = input_at(t);
    struct um_vec3 e = um_vec3(0.6, 0.48, 0.64);
    assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &eop, t, &earth));
    struct um_vec3 in_earth = um_mat3_apply(earth, e);
    assert_vec_near(um_quat_apply(attitude_at(context, attitude, &input), e),
                    um_vec3(in_earth.y, -in_earth.x, in_earth.z), 1e-8);
  }
  um_orbit_attitude_destroy(&attitude);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {HEAD META("GTOD", "SC_BODY_1", "A2B", "FIRST") FIRST,
       ":6: REF_FRAME_A: 'GTOD'; accepted: GCRF, ICRF, EME2000, ITRF, TEME, TOD, MOD, SC_BODY_1, "
       "SATELLITE_FRAME"},
      {XML("2.0", "GCRF", "SC_BODY_1", "") "\n<attitudeState>\n<EPOCH>2016-265T20:00:30</EPOCH>"
                                           "<QC>1</QC>\n</attitudeState>",
       ":5: the attitudeState that begins here has no Q1"},
      {XML("1.0", "GCRF", "SC_BODY_1", "") XML_ROWS, ":3: the segment has no ATTITUDE_DIR"},
      {XML("2.0", "GCRF", "SC_BODY_1", "\n<ATTITUDE_TYPE>SPIN</ATTITUDE_TYPE>") XML_ROWS,
       ":4: ATTITUDE_TYPE: 'SPIN'; accepted: QUATERNION"},
      {"<oem/>", ": no element aem; accepted: navigation messages (NDM/XML) with one"},
      {HEAD META("GCRF", "ICRF", "A2B", "FIRST") FIRST,
       ":12: the segment has no frame of the body; accepted: REF_FRAME_A or B"},
      {HEAD META("SC_BODY_1", "SC_BODY_2", "A2B", "FIRST") FIRST,
       ":12: the segment has no frame beside the body's; accepted: REF_FRAME_A or B"},
      {HEAD META("GCRF", "SC_BODY_1", "B2C", "FIRST") FIRST,
       ":8: ATTITUDE_DIR: 'B2C'; accepted: A2B, B2A"},
      {HEAD META("GCRF", "SC_BODY_1", "A2B", "MIDDLE") FIRST,
       ":11: QUATERNION_TYPE: 'MIDDLE'; accepted: FIRST, LAST"},
      {HEAD "META_START\nATTITUDE_TYPE = SPIN\n",
       ":5: ATTITUDE_TYPE: 'SPIN'; accepted: QUATERNION"},
      {HEAD "META_START\nREF_FRAME_A = GCRF\nREF_FRAME_B = SC_BODY_1\nTIME_SYSTEM = UTC\n"
            "ATTITUDE_TYPE = QUATERNION\nMETA_STOP\n",
       ":9: the segment has no ATTITUDE_DIR"},
      {HEAD META("GCRF", "SC_BODY_1", "A2B", "FIRST") "2016-09-21T20:00:00 1 0 0 0.1\n",
       ":14: the quaternion has norm 1.00499, 1 within 0.001 is accepted"},
      {HEAD META("GCRF", "SC_BODY_1", "A2B", "FIRST") "2016-09-21T20:00:00 1 0 0\n",
       ":14: 4 fields; accepted: a time, 4 of a quaternion"},
      {HEAD META("GCRF", "SC_BODY_1", "A2B", "FIRST") "2016-09-21T20:00:00 1 0 0 0\n",
       ": 1 rows, at least 2 are accepted"},
      {HEAD META("GCRF", "SC_BODY_1", "A2B", "FIRST") FIRST "2016-09-21T20:01:00 1 0 0 0\n"
                                                            "2016-09-21T21:01:00 1 0 0 0\n",
       ": a gap of 3600.000 s before 2016-09-21T21:01:00.000Z, at most 300.000 s is accepted"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_attitude *attitude = NULL;
    char path[256];
    scratch_write("aem", cases[k].text, path);
    struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_TABLE, .table_path = path};
    assert_int_equal(um_orbit_attitude_create(context, &law, 1, &attitude), UM_ERR_INPUT);
    remove(path);
    assert_string_equal(um_core_message(context) + strlen(path), cases[k].message);
    assert_null(attitude);
    um_core_message_clear(context);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(turns, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(frame_bias, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(turning_frame, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
