/* Files of element sets: what is read of each way to write them, which set serves when, and the
 * exact message of every fault. */
#include "orbit_test.h"

#include "orbit/elements.h"
#include "orbit/trajectory.h"

/* GOES 9: the example of CCSDS 502.0-B, which has the two-line set and the message made of it. */
#define GOES_LINES                                                                                 \
  "1 23581U 95025A   07064.44075725 -.00000113  00000-0  10000-3 0  9250\n"                        \
  "2 23581   3.0539  81.7939 0005013 249.2363 150.1602  1.00273272 43169\n"
#define KVN_HEAD "CCSDS_OMM_VERS = 2.0\nCREATION_DATE = 2007-065T16:00:00\nORIGINATOR = NOAA/USA\n"
#define KVN_META                                                                                   \
  "OBJECT_NAME = GOES 9\nOBJECT_ID = 1995-025A\nCENTER_NAME = EARTH\nREF_FRAME = TEME\n"           \
  "TIME_SYSTEM = UTC\nMEAN_ELEMENT_THEORY = SGP/SGP4\nCOMMENT USAF SGP4\n"
#define KVN_DATA                                                                                   \
  "EPOCH = 2007-064T10:34:41.4264\nMEAN_MOTION = 1.00273272 [rev/day]\nECCENTRICITY = 0.0005013\n" \
  "INCLINATION = 3.0539\nRA_OF_ASC_NODE = 81.7939 [deg]\nARG_OF_PERICENTER = 249.2363\n"           \
  "MEAN_ANOMALY = 150.1602\n"
#define KVN_TLE                                                                                    \
  "EPHEMERIS_TYPE = 0\nNORAD_CAT_ID = 23581\nBSTAR = 0.0001\nMEAN_MOTION_DOT = -0.00000113\n"      \
  "MEAN_MOTION_DDOT = 0.0\n"
#define JSON_REST                                                                                  \
  "\"EPOCH\":\"2007-03-05T10:34:41.426400\",\"MEAN_MOTION\":1.00273272,\"ECCENTRICITY\":5.013e-4," \
  "\"INCLINATION\":\"3.0539\",\"RA_OF_ASC_NODE\":81.7939,\"ARG_OF_PERICENTER\":249.2363,"          \
  "\"MEAN_ANOMALY\":150.1602,\"CLASSIFICATION_TYPE\":\"U\",\"BSTAR\":0.0001,"                      \
  "\"MEAN_MOTION_DOT\":-1.13e-6,\"MEAN_MOTION_DDOT\":0,\"NORAD_CAT_ID\":"
#define CSV_HEAD                                                                                   \
  "OBJECT_NAME,OBJECT_ID,EPOCH,MEAN_MOTION,ECCENTRICITY,INCLINATION,RA_OF_ASC_NODE,"               \
  "ARG_OF_PERICENTER,MEAN_ANOMALY,NORAD_CAT_ID,BSTAR,MEAN_MOTION_DOT,MEAN_MOTION_DDOT\n"
#define CSV_ROW                                                                                    \
  "GOES 9,1995-025A,2007-03-05T10:34:41.426400,1.00273272,.0005013,3.0539,81.7939,249.2363,"       \
  "150.1602,23581,.0001,-.00000113,0\n"

#define XML_HEAD                                                                                   \
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ndm xmlns=\"urn:ccsds:schema:ndmxml\">"            \
  "<omm id=\"CCSDS_OMM_VERS\" version=\"2.0\"><header><ORIGINATOR>X</ORIGINATOR></header>\n"       \
  "<body><segment><metadata><OBJECT_ID>1995-025A</OBJECT_ID><REF_FRAME>TEME</REF_FRAME>\n"
#define XML_SET                                                                                    \
  "</metadata><data><meanElements><EPOCH>2007-064T10:34:41.4264</EPOCH>"                           \
  "<MEAN_MOTION units=\"rev/day\">1.00273272</MEAN_MOTION>\n<ECCENTRICITY>\n 0.0005013 \n"         \
  "</ECCENTRICITY><INCLINATION>3.0539</INCLINATION><RA_OF_ASC_NODE>81.7939</RA_OF_ASC_NODE>"       \
  "<ARG_OF_PERICENTER>249.2363</ARG_OF_PERICENTER><MEAN_ANOMALY>150.1602</MEAN_ANOMALY>"           \
  "</meanElements><tleParameters><NORAD_CAT_ID>23581</NORAD_CAT_ID><BSTAR>0.0001</BSTAR>"          \
  "<MEAN_MOTION_DOT>-0.00000113</MEAN_MOTION_DOT></tleParameters>"
#define XML_TAIL "</data></segment></body></omm></ndm>\n"

static enum um_status parse(struct um_context *context, const char *text, int object,
                            struct um_orbit_elements *out)
{
  return um_orbit_elements_parse(context, "sets", text, strlen(text), object, out);
}

/* Every way to write the example says what its two lines say. */
static void one_set(void **state)
{
  struct um_context *context = *state;
  static const char *const texts[] = {
      GOES_LINES,
      "\xEF\xBB\xBFGOES 9\r\n" GOES_LINES,
      KVN_HEAD KVN_META KVN_DATA KVN_TLE,
      "\n" KVN_HEAD KVN_META KVN_DATA KVN_TLE "USER_DEFINED_X = 1\n",
      "{" JSON_REST "23581}",
      " [{" JSON_REST "\"23581\"}]\n",
      CSV_HEAD CSV_ROW,
      XML_HEAD XML_SET XML_TAIL,
  };
  struct um_orbit_tle tle;
  assert_ok(context, um_orbit_tle_parse(context, GOES_LINES, 1, &tle));
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    struct um_orbit_elements e;
    assert_ok(context, parse(context, texts[k], 0, &e));
    assert_int_equal(e.count, 1);
    const struct um_orbit_tle *set = &e.set[0];
    assert_int_equal(set->catalogue_number, 23581);
    assert_close(set->epoch_tai, tle.epoch_tai, 1e-6);
    assert_close(set->epoch_jd[0] + set->epoch_jd[1], tle.epoch_jd[0] + tle.epoch_jd[1], 1e-9);
    assert_close(set->mean_motion, tle.mean_motion, 1e-17);
    assert_close(set->mean_motion_dot, tle.mean_motion_dot, 1e-20);
    assert_close(set->mean_motion_ddot, 0.0, 0.0);
    assert_close(set->bstar, tle.bstar, 1e-19);
    assert_close(set->inclination, tle.inclination, 1e-15);
    assert_close(set->raan, tle.raan, 1e-15);
    assert_close(set->eccentricity, tle.eccentricity, 1e-18);
    assert_close(set->argument_of_perigee, tle.argument_of_perigee, 1e-15);
    assert_close(set->mean_anomaly, tle.mean_anomaly, 1e-15);
    um_orbit_elements_release(context, &e);
  }
}

/* Numbers beyond what two lines have room for. */
static void nine_digits(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_elements e;
  assert_ok(context, parse(context, "{" JSON_REST "799500001}", 0, &e));
  assert_int_equal(e.set[0].catalogue_number, 799500001);
  um_orbit_elements_release(context, &e);
}

/* ENVISAT on two days, and another object. */
#define DAY_250                                                                                    \
  "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"                        \
  "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
#define DAY_252                                                                                    \
  "ENVISAT\n1 27386U 02009A   16252.75012691  .00000017  00000-0  19645-4 0  9991\n"               \
  "2 27386  98.2753 303.1863 0001254  76.0013 188.0311 14.37874790760639\n"

/* Sets of one object by their epochs, those of others left out; of equal epochs the last. */
static void several(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_elements e;
  assert_ok(context, parse(context, DAY_252 "\n\n" GOES_LINES DAY_250 DAY_250, 27386, &e));
  assert_int_equal(e.count, 2);
  double first = e.set[0].epoch_tai;
  assert_close(e.set[1].epoch_tai - first, 2.0 * 86400.0, 1e-6);
  assert_int_equal(um_orbit_elements_nearest(&e, first + 86399.0), 0);
  assert_int_equal(um_orbit_elements_nearest(&e, first + 86401.0), 1);
  assert_int_equal(um_orbit_elements_nearest(&e, first - 1e9), 0);
  um_orbit_elements_release(context, &e);
}

/* At each time the place is that of the nearest set alone. */
static void nearest_in_time(void **state)
{
  struct um_context *context = *state;
  static const double days[] = {-3.0, 0.0, 0.4, 0.99999, 1.00001, 1.7, 2.0, 9.0};
  const struct um_orbit_earth_orientation eop = {0};
  struct um_orbit_elements e;
  struct um_orbit_trajectory *all = NULL, *one[2] = {NULL, NULL};
  assert_ok(context, parse(context, DAY_250 DAY_252, 0, &e));
  double first = e.set[0].epoch_tai;
  assert_ok(context, um_orbit_trajectory_create_elements(context, &e, first + 1e5, &eop, &all));
  for (int k = 0; k < 2; k++)
    assert_ok(context, um_orbit_trajectory_create_tle(context, &e.set[k], &eop, &one[k]));
  assert_close(um_orbit_trajectory_epoch(all), e.set[1].epoch_tai, 0.0);
  assert_close(um_orbit_trajectory_period(all), um_orbit_trajectory_period(one[1]), 0.0);
  for (size_t i = 0; i < sizeof days / sizeof days[0]; i++) {
    struct um_vec3 r, v, own, other;
    double t = first + 86400.0 * days[i];
    int k = days[i] > 1.0;
    assert_ok(context, um_orbit_trajectory_state(context, all, t, &r, &v));
    assert_ok(context, um_orbit_trajectory_state(context, one[k], t, &own, NULL));
    assert_ok(context, um_orbit_trajectory_state(context, one[1 - k], t, &other, NULL));
    assert_close(um_vec3_norm(um_vec3_sub(r, own)), 0.0, 0.0);
    assert_true(um_vec3_norm(um_vec3_sub(r, other)) > 100.0); /* the sets disagree */
  }
  um_orbit_trajectory_destroy(&all);
  for (int k = 0; k < 2; k++) um_orbit_trajectory_destroy(&one[k]);
  um_orbit_elements_release(context, &e);
}

#define ACCEPTED "two-line elements, mean-elements messages (OMM) as key = value, XML, JSON or CSV"

#define LONG "0123456789012345678901234567890123456789012345678"

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text;
    int object;
    const char *message;
  } cases[] = {
      {"", 0,
       "sets: TLE: line 1 is missing; two lines that begin with '1 ' and '2 ', with or without a "
       "name line before them, are accepted"},
      {"[]", 0, "sets: no element set; accepted: one or more"},
      {"<?xml version=\"1.0\"?><ndm/>", 0,
       "sets: no element omm; accepted: navigation messages (NDM/XML) with one"},
      {XML_HEAD XML_SET, 0, "sets:7: not XML as it should be: no element found"},
      {XML_HEAD "<REF_FRAME>GCRF</REF_FRAME>" XML_SET XML_TAIL, 0,
       "sets:4: REF_FRAME stands in line 3 already"},
      {XML_HEAD "<TIME_SYSTEM>UT1</TIME_SYSTEM>" XML_SET XML_TAIL, 0,
       "sets:4: TIME_SYSTEM: 'UT1'; accepted: UTC"},
      {"<!DOCTYPE x [<!ENTITY a \"b\">]>\n" XML_HEAD XML_SET XML_TAIL, 0,
       "sets:1: a document type; accepted: navigation messages without"},
      {XML_HEAD "<OBJECT_ID>" LONG LONG "</OBJECT_ID>", 0,
       "sets:4: OBJECT_ID is longer than 79 bytes; accepted: no more"},
      {XML_HEAD XML_TAIL, 0, "sets:4: not XML as it should be: mismatched tag"},
      {"CCSDS_OEM_VERS = 2.0\n", 0, "sets: another message, CCSDS_OEM_VERS; accepted: " ACCEPTED},
      {DAY_250 GOES_LINES, 0,
       "sets: sets of several objects, 27386 and 23581 the first of them; accepted: sets of one, "
       "or "
       "orbit.elements.object"},
      {DAY_250, 5, "sets: no set of object 5; the first one is of 27386"},
      {DAY_250 "\nX\n1 27386U\n", 0,
       "sets: set that begins in line 4: TLE: line 2 is missing; two lines that begin with '1 ' "
       "and "
       "'2 ', with or without a name line before them, are accepted"},
      {KVN_HEAD KVN_META KVN_TLE, 0,
       "sets:1: the mean-elements message that begins here has no EPOCH"},
      {KVN_HEAD "REF_FRAME = GCRF\n" KVN_DATA KVN_TLE, 0,
       "sets:4: REF_FRAME: 'GCRF'; accepted: TEME"},
      {KVN_HEAD "MEAN_ELEMENT_THEORY = DSST\n" KVN_DATA KVN_TLE, 0,
       "sets:4: MEAN_ELEMENT_THEORY: 'DSST'; accepted: SGP4"},
      {KVN_HEAD KVN_DATA KVN_TLE "INCLINATION = 4\n", 0,
       "sets:16: INCLINATION stands in line 7 already"},
      {KVN_HEAD KVN_DATA KVN_TLE KVN_HEAD "INCLINATION = 180.1\n" KVN_DATA, 0,
       "sets:23: INCLINATION stands in line 19 already"},
      {KVN_HEAD "INCLINATION 4\n", 0, "sets:4: 'INCLINATION 4'; accepted: KEYWORD = value"},
      {"{" JSON_REST "\"A0001\"}", 0, "sets:1: NORAD_CAT_ID: 'A0001'; accepted: 0 to 999999999"},
      {"{" JSON_REST "1.5}", 0, "sets:1: NORAD_CAT_ID: '1.5'; accepted: a whole number"},
      {"[\n{" JSON_REST "1},\n{\"BSTAR\": 1}]", 1,
       "sets:3: the mean-elements message that begins here has no EPOCH"},
      {CSV_HEAD "GOES 9,1995-025A,2007-03-05T10:34:41,1.0,1,3,81,249,150,23581,.0001,0,0\n", 0,
       "sets:2: ECCENTRICITY: '1'; accepted: 0 to 0.9999999"},
      {CSV_HEAD "GOES 9,1995-025A,yesterday,1.0,0,3,81,249,150,23581,.0001,0,0\n", 0,
       "sets:2: EPOCH: 'yesterday'; accepted: "},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_elements e;
    assert_int_equal(parse(context, cases[k].text, cases[k].object, &e), UM_ERR_INPUT);
    if (strncmp(um_core_message(context), cases[k].message, strlen(cases[k].message)) != 0)
      assert_string_equal(um_core_message(context), cases[k].message);
    assert_null(e.set);
    um_core_message_clear(context);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(one_set, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(nine_digits, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(several, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(nearest_in_time, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
