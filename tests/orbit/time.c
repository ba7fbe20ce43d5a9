/* Time scales: leap seconds, rounding, round trips, refusals. Expected values are those of the
 * definitions (TT - TAI = 32.184 s) and of the IERS list of leap seconds (Bulletin C). */
#include "orbit_test.h"

/* 2000-01-01T12:00:00 TAI is 11:59:28 UTC, as TAI - UTC was 32 s. */
static void origin(void **state)
{
  struct um_context *context = *state;
  /* one day fraction in double precision resolves 1e-11 s */
  assert_near(utc(context, "2000-01-01T11:59:28Z"), 0.0, 1e-9);
  assert_near(utc(context, "2000-01-01T12:00:00"), 32.0, 1e-9);
  /* 6108 days and TAI - UTC = 36 s: 6108 x 86400 + (20:33 - 12:00 = 30780 s) + 36 */
  assert_near(utc(context, "2016-09-21T20:33:00.5Z"), 6108.0 * 86400.0 + 30780.0 + 36.5, 1e-7);
}

/* The second 60 of 2016-12-31 lasts; TAI runs through. */
static void leap_second(void **state)
{
  struct um_context *context = *state;
  double before = utc(context, "2016-12-31T23:59:59Z"), leap = utc(context, "2016-12-31T23:59:60Z");
  double after = utc(context, "2017-01-01T00:00:00Z");
  assert_near(leap - before, 1.0, 1e-7);
  assert_near(after - before, 2.0, 1e-7);
  char text[32];
  um_orbit_time_format(leap + 0.25, text);
  assert_string_equal(text, "2016-12-31T23:59:60.250Z");
  um_orbit_time_format(after, text);
  assert_string_equal(text, "2017-01-01T00:00:00.000Z");
  um_orbit_time_format(leap + 0.9997, text);
  assert_string_equal(text, "2017-01-01T00:00:00.000Z");
}

/* To 1 ms, carried through minutes, days and years. */
static void rounding(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *in, *out;
  } cases[] = {{"2016-09-21T20:33:00.9994Z", "2016-09-21T20:33:00.999Z"},
               {"2016-09-21T20:33:00.9996Z", "2016-09-21T20:33:01.000Z"},
               {"2016-09-21T20:59:59.9996Z", "2016-09-21T21:00:00.000Z"},
               {"2015-12-31T23:59:59.9996Z", "2016-01-01T00:00:00.000Z"},
               {"2016-02-29T00:00:00.0004Z", "2016-02-29T00:00:00.000Z"},
               {"1999-12-31T23:59:59.123456789Z", "1999-12-31T23:59:59.123Z"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    char text[32];
    um_orbit_time_format(utc(context, cases[k].in), text);
    assert_string_equal(text, cases[k].out);
  }
  /* exactly .9995 becomes the next second (half up) or .999, never .1000 */
  char text[32];
  um_orbit_time_format(utc(context, "2016-09-21T20:33:00.9995Z"), text);
  assert_int_equal(strlen(text), 24);
  assert_true(strcmp(text, "2016-09-21T20:33:01.000Z") == 0 ||
              strcmp(text, "2016-09-21T20:33:00.999Z") == 0);
}

/* Every hour and some of a century: text -> time -> text is the identity at 1 ms. */
static void round_trip(void **state)
{
  struct um_context *context = *state;
  for (int k = 0; k < 20000; k++) {
    char text[32], again[32];
    double t = -8.8e8 + 1.1e5 * k + 0.001 * (k % 1000); /* 1972-02 to 2041 */
    um_orbit_time_format(t, text);
    double back = utc(context, text);
    if (!(fabs(back - t) <= 0.00051)) fail_msg("%s: %.6f s apart", text, back - t);
    um_orbit_time_format(back, again);
    assert_string_equal(again, text);
  }
}

static void scales(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, "2016-09-21T20:33:00Z"), tt[2], jd_utc[2], ut1[2];
  um_orbit_time_tt(t, tt);
  um_orbit_time_utc(t, jd_utc);
  um_orbit_time_ut1(t, -0.267794, ut1);
  /* JD of 2016-09-21T00:00 is 2457652.5 (Meeus, chapter 7); 1e-14 d = 1 ns after the subtraction */
  double day = 73980.0 / 86400.0;
  assert_near(((jd_utc[0] - 2457652.5) + jd_utc[1]) * 86400.0, day * 86400.0, 1e-6);
  assert_near(((tt[0] - 2457652.5) + tt[1]) * 86400.0, 73980.0 + 36.0 + 32.184, 1e-6);
  assert_near(((ut1[0] - 2457652.5) + ut1[1]) * 86400.0, 73980.0 - 0.267794, 1e-6);
  assert_near(um_orbit_time_from_utc_jd(jd_utc[0], jd_utc[1]), t, 2e-7);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"2016-09-21T23:59:60Z",
       "'2016-09-21T23:59:60Z': that minute has no leap second (seconds are below 60)"},
      {"2016-12-31T22:59:60Z",
       "'2016-12-31T22:59:60Z': that minute has no leap second (seconds are below 60)"},
      {"2016-12-31T23:59:61Z",
       "'2016-12-31T23:59:61Z': that minute has no leap second (seconds are below 60)"},
      {"2015-02-29T00:00:00Z", "'2015-02-29T00:00:00Z': that month does not have this day"},
      {"2015-13-01T00:00:00Z", "'2015-13-01T00:00:00Z': the month is 01 to 12"},
      {"2015-01-01T24:00:00Z", "'2015-01-01T24:00:00Z': the hour is 00 to 23"},
      {"2015-01-01T00:60:00Z", "'2015-01-01T00:60:00Z': the minute is 00 to 59"},
      {"1959-01-01T00:00:00Z", "'1959-01-01T00:00:00Z': the year 1959 is outside 1960 to 2100"},
      {"2101-01-01T00:00:00Z", "'2101-01-01T00:00:00Z': the year 2101 is outside 1960 to 2100"},
      {"2016-09-21 20:33:00",
       "'2016-09-21 20:33:00' is not a UTC time like 2016-09-21T20:33:00.000Z"},
      {"2016-09-21T20:33:00+02:00",
       "'2016-09-21T20:33:00+02:00' is not a UTC time like 2016-09-21T20:33:00.000Z"},
      {"2016-09-21T20:33:00.Z",
       "'2016-09-21T20:33:00.Z' is not a UTC time like 2016-09-21T20:33:00.000Z"},
      {"nan", "'nan' is not a UTC time like 2016-09-21T20:33:00.000Z"},
      {"", "'' is not a UTC time like 2016-09-21T20:33:00.000Z"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    double t;
    um_core_message_clear(context);
    assert_int_equal(um_orbit_time_parse(context, cases[k].text, &t), UM_ERR_INPUT);
    assert_string_equal(um_core_message(context), cases[k].message);
  }
}

/* As the hook of a schema: what is accepted, to stand behind the text that is not. */
static void hook(void **state)
{
  (void)state;
  char accepted[160];
  double t = 0.0, again = 0.0;
  assert_false(um_orbit_time_parse_hook("yesterday", &t, accepted, sizeof accepted));
  assert_string_equal(accepted, "a UTC time like 2016-09-21T20:33:00Z");
  assert_false(um_orbit_time_parse_hook("2015-02-29T00:00:00Z", &t, accepted, sizeof accepted));
  assert_string_equal(accepted, "a UTC time like 2016-09-21T20:33:00Z (that month does not have "
                                "this day)");
  assert_true(um_orbit_time_parse_hook("2015-02-28T00:00:00Z", &t, accepted, sizeof accepted));
  assert_true(um_orbit_time_parse_field("2015-02-28T00:00:00Z", &again, accepted, sizeof accepted));
  assert_true(t == again);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(origin, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(leap_second, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(rounding, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(round_trip, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(scales, context_setup, context_teardown),
      cmocka_unit_test(hook),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
