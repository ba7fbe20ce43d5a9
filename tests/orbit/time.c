/* Time scales: leap seconds, rounding, round trips, refusals. Expected values are those of the
 * definitions (TT - TAI = 32.184 s) and of the IERS list of leap seconds (Bulletin C). */
#include "orbit/time_form.h"
#include "orbit_test.h"

/* 2000-01-01T12:00:00 TAI is 11:59:28 UTC, as TAI - UTC was 32 s. */
static void origin(void **state)
{
  struct um_context *context = *state;
  /* one day fraction in double precision resolves 1e-11 s */
  assert_close(utc(context, "2000-01-01T11:59:28Z"), 0.0, 1e-9);
  assert_close(utc(context, "2000-01-01T12:00:00"), 32.0, 1e-9);
  /* 6108 days and TAI - UTC = 36 s: 6108 x 86400 + (20:33 - 12:00 = 30780 s) + 36 */
  assert_close(utc(context, "2016-09-21T20:33:00.5Z"), 6108.0 * 86400.0 + 30780.0 + 36.5, 1e-7);
}

/* The second 60 of 2016-12-31 lasts; TAI runs through. */
static void leap_second(void **state)
{
  struct um_context *context = *state;
  double before = utc(context, "2016-12-31T23:59:59Z"), leap = utc(context, "2016-12-31T23:59:60Z");
  double after = utc(context, "2017-01-01T00:00:00Z");
  assert_close(leap - before, 1.0, 1e-7);
  assert_close(after - before, 2.0, 1e-7);
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

/* What a clock shows through the leap second at the end of 2016 (IERS Bulletin C 52), and how many
 * there were: 37 - 32 s from 2000 to 2020, 27 before the first UTC text of 2017 since 1972. */
static void clock_and_leap_seconds(void **state)
{
  (void)state;
  static const struct {
    const char *utc;
    double mjd, seconds;
  } at[] = {{"2000-01-01T12:00:00Z", 51544, 43200.0}, {"2016-12-31T23:59:59.25Z", 57753, 86399.25},
            {"2016-12-31T23:59:60Z", 57753, 86400.0}, {"2016-12-31T23:59:60.75Z", 57753, 86400.75},
            {"2017-01-01T00:00:00Z", 57754, 0.0},     {"2017-12-31T23:59:59Z", 58118, 86399.0}};
  double t[6], mjd, seconds, from, to;
  for (size_t i = 0; i < 6; i++) {
    assert_true(um_orbit_time_parse_field(at[i].utc, &t[i], (char[160]){0}, 160));
    um_orbit_time_utc_clock(t[i], &mjd, &seconds);
    assert_true(mjd == at[i].mjd);
    assert_close(seconds, at[i].seconds, 2e-7); /* t_tai resolves 0.06 us */
  }
  assert_int_equal(um_orbit_time_leap_seconds(t[1], t[4]), 1);
  assert_int_equal(um_orbit_time_leap_seconds(t[4], t[5]), 0);
  assert_true(um_orbit_time_parse_field("1972-01-01T00:00:00Z", &from, (char[160]){0}, 160));
  assert_int_equal(um_orbit_time_leap_seconds(from, t[4]), 27);
  assert_true(um_orbit_time_parse_field("2020-01-01T00:00:00Z", &to, (char[160]){0}, 160));
  assert_int_equal(um_orbit_time_leap_seconds(t[0], to), 5);
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
  assert_close(((jd_utc[0] - 2457652.5) + jd_utc[1]) * 86400.0, day * 86400.0, 1e-6);
  assert_close(((tt[0] - 2457652.5) + tt[1]) * 86400.0, 73980.0 + 36.0 + 32.184, 1e-6);
  assert_close(((ut1[0] - 2457652.5) + ut1[1]) * 86400.0, 73980.0 - 0.267794, 1e-6);
  assert_close(um_orbit_time_from_utc_jd(jd_utc[0], jd_utc[1]), t, 2e-7);
}

static double form(enum um_orbit_time_form f, const char *text)
{
  char why[160];
  double t = NAN;
  if (!um_orbit_time_form_parse(f, text, &t, why, sizeof why)) fail_msg("%s", why);
  return t;
}

/* Numbers of one instant. POSIX seconds as `date -u +%s` has them; Julian dates of Meeus,
 * Astronomical Algorithms (1998), examples 7.a and its table; MJD 57753.5 is 12:00:00.5 because
 * that day is 86401 s long (SOFA's quasi-JD, 4.5). 2e-7 s: a double of t_tai. */
static void forms(void **state)
{
  struct um_context *context = *state;
  static const struct {
    enum um_orbit_time_form form;
    const char *text, *utc;
  } cases[] = {{UM_ORBIT_TIME_UNIX, "1474489980.25", "2016-09-21T20:33:00.25Z"},
               {UM_ORBIT_TIME_UNIX, "0", "1970-01-01T00:00:00Z"},
               {UM_ORBIT_TIME_UNIX, "1483228799.5", "2016-12-31T23:59:59.5Z"},
               {UM_ORBIT_TIME_UNIX, "1483228800", "2017-01-01T00:00:00Z"},
               {UM_ORBIT_TIME_UNIX, "1483185600", "2016-12-31T12:00:00Z"},
               {UM_ORBIT_TIME_UNIX, "-0.25", "1969-12-31T23:59:59.75Z"},
               {UM_ORBIT_TIME_UNIX, "-86400", "1969-12-31T00:00:00Z"},
               {UM_ORBIT_TIME_JD, "2436116.31", NULL}, /* 1957: before 1960 */
               {UM_ORBIT_TIME_JD, "2451545.0", "2000-01-01T12:00:00Z"},
               {UM_ORBIT_TIME_JD, "2446822.5", "1987-01-27T00:00:00Z"},
               {UM_ORBIT_TIME_JD, "2447332", "1988-06-19T12:00:00Z"},
               {UM_ORBIT_TIME_MJD, "57652.85625", "2016-09-21T20:33:00Z"},
               {UM_ORBIT_TIME_MJD, "57753.5", "2016-12-31T12:00:00.5Z"},
               {UM_ORBIT_TIME_MJD, "57754", "2017-01-01T00:00:00Z"},
               {UM_ORBIT_TIME_ISO, "2016-12-31 23:59:60.5", "2016-12-31T23:59:60.5Z"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    char why[160];
    double t;
    if (cases[k].utc == NULL)
      assert_false(um_orbit_time_form_parse(cases[k].form, cases[k].text, &t, why, sizeof why));
    else
      assert_close(form(cases[k].form, cases[k].text), utc(context, cases[k].utc), 2e-7);
  }
}

/* Text -> time through each form at random instants: digits written from whole days and
 * microseconds of the day by integers, so that they are exact. */
static void forms_round_trip(void **state)
{
  struct um_context *context = *state;
  for (long k = 0; k < 20000; k++) {
    long day = 41317 + (k * 7919) % 40000,
         micro = (k * 4000037L) % 86400 * 1000000 + k * 37 % 1000000;
    /* days that end in a leap second are longer: their fractions are another matter (forms) */
    char text[64], why[160];
    double iso, t, second = 1e-6 * (double)micro;
    snprintf(text, sizeof text, "%ld.%06ld", (day - 40587) * 86400 + micro / 1000000,
             micro % 1000000);
    t = form(UM_ORBIT_TIME_UNIX, text);
    double jd[2], midnight[2];
    um_orbit_time_utc(t, jd);
    midnight[0] = 2400000.5 + (double)day;
    midnight[1] = (jd[0] - midnight[0]) + jd[1];
    double length = um_orbit_time_from_utc_jd(midnight[0] + 1.0, 0.0) -
                    um_orbit_time_from_utc_jd(midnight[0], 0.0);
    assert_close(midnight[1] * length, second, 1e-6);
    um_orbit_time_format(t, text);
    assert_true(um_orbit_time_form_parse(UM_ORBIT_TIME_ISO, text, &iso, why, sizeof why));
    assert_close(iso, t, 5.1e-4);
    if (fabs(length - 86400.0) > 1e-6) continue;
    /* micro / 86400e6 = 18 digits, cut: 1e-18 d */
    snprintf(text, sizeof text, "%ld.", day);
    size_t n = strlen(text);
    long rest = micro;
    for (int digit = 0; digit < 18; digit++) {
      rest *= 10;
      text[n++] = (char)('0' + rest / 86400000000L);
      rest %= 86400000000L;
    }
    text[n] = '\0';
    assert_close(form(UM_ORBIT_TIME_MJD, text), t, 2.5e-7);
  }
  (void)context;
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
      {"2016-09-21  20:33:00",
       "'2016-09-21  20:33:00' is not a UTC time like 2016-09-21T20:33:00.000Z"},
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
      cmocka_unit_test_setup_teardown(clock_and_leap_seconds, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(rounding, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(round_trip, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(scales, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(forms, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(forms_round_trip, context_setup, context_teardown),
      cmocka_unit_test(hook),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
