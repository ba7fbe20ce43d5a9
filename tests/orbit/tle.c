/* Two-line elements: values of a set, and the exact message of every fault. */
#include "orbit_test.h"

#include "orbit/tle.h"

#define LINE_1 "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999"
#define LINE_2 "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345"

/* ENVISAT, 2016-09-06, with every dressing that is accepted. Values as printed in the set. */
static void values(void **state)
{
  struct um_context *context = *state;
  static const char *const texts[] = {
      LINE_1 "\n" LINE_2, LINE_1 "\n" LINE_2 "\n", "ENVISAT\n" LINE_1 "\n" LINE_2 "\n",
      "0 ENVISAT\r\n" LINE_1 "\r\n" LINE_2 "\r\n\r\n", "\n" LINE_1 "   \n" LINE_2 "  \t\n\n"};
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
    struct um_orbit_tle tle;
    assert_ok(context, um_orbit_tle_parse(context, texts[k], 1, &tle));
    assert_int_equal(tle.catalogue_number, 27386);
    assert_string_equal(tle.designator, "02009A");
    /* day 250 of the leap year 2016 is 6 September, JD 2457637.5 */
    assert_close(tle.epoch_jd[0], 2457637.5, 0.0);
    assert_close(tle.epoch_jd[1], 0.75012691, 1e-13);
    assert_close(tle.epoch_tai, utc(context, "2016-09-06T18:00:10.965024Z"), 1e-6);
    assert_close(tle.mean_motion_dot, 0.00000017, 0.0);
    assert_close(tle.mean_motion_ddot, 0.0, 0.0);
    assert_close(tle.bstar, 0.19645e-4, 1e-20);
    assert_close(tle.inclination, 98.2753 * UM_DEG, 1e-15);
    assert_close(tle.raan, 301.2152 * UM_DEG, 1e-15);
    assert_close(tle.eccentricity, 0.0001254, 1e-18);
    assert_close(tle.argument_of_perigee, 82.1013 * UM_DEG, 1e-15);
    assert_close(tle.mean_anomaly, 278.0311 * UM_DEG, 1e-15);
    assert_close(tle.mean_motion, 14.37874790 * 2.0 * UM_PI / 1440.0, 1e-16);
  }
}

/* Alpha-5: A0000 is 100000, Z9999 is 339999; I and O are not used. Checksums are not looked at. */
static void alpha_5(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *code;
    int number;
  } cases[] = {{"A0000", 100000}, {"H9999", 179999}, {"J0000", 180000}, {"P0001", 230001},
               {"Z9999", 339999}, {"    5", 5},      {"00005", 5}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    char text[] = LINE_1 "\n" LINE_2;
    struct um_orbit_tle tle;
    memcpy(text + 2, cases[k].code, 5);
    memcpy(strchr(text, '\n') + 3, cases[k].code, 5);
    assert_ok(context, um_orbit_tle_parse(context, text, 0, &tle));
    assert_int_equal(tle.catalogue_number, cases[k].number);
  }
}

/* Negative exponents and signs of the fields of line 1. */
static void exponent_fields(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_tle tle;
  static const char text[] =
      "1 16925U 86065D   06151.67415771 -.02550794 -30915-6 -18784+1 0  4486\n"
      "2 16925  62.0906 295.0239 5596327 245.1593  47.9690  4.88511875148616\n";
  assert_ok(context, um_orbit_tle_parse(context, text, 0, &tle));
  assert_close(tle.mean_motion_dot, -0.02550794, 1e-17);
  assert_close(tle.mean_motion_ddot, -0.30915e-6, 1e-21);
  assert_close(tle.bstar, -1.8784, 1e-15);
}

static void refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {LINE_1 "\n2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760344",
       "TLE line 2: checksum is 5, the line says 4"},
      {"1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  999X\n" LINE_2,
       "TLE line 1, column 69 (checksum): 'X', a digit is accepted"},
      {"1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  999\n" LINE_2,
       "TLE line 1: 68 characters, 69 are accepted"},
      {LINE_1 "\n" LINE_2 "9", "TLE line 2: 70 characters, 69 are accepted"},
      {LINE_1 "\n2 27387  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760346",
       "TLE: line 1 is of catalogue number 27386, line 2 of 27387; equal numbers are accepted"},
      {LINE_1 "\n2 27386  98.2x53 301.2152 0001254  82.1013 278.0311 14.37874790760348",
       "TLE line 2, columns 9-16 (inclination): ' 98.2x53', a number with digits and one decimal "
       "point is accepted"},
      {LINE_1 "\n2 27386 198.2753 301.2152 0001254  82.1013 278.0311 14.37874790760346",
       "TLE line 2, columns 9-16 (inclination): '198.2753', 0 to 180 deg is accepted"},
      {LINE_1 "\n2 27386  98.2753 301.2152 00A1254  82.1013 278.0311 14.37874790760345",
       "TLE line 2, columns 27-33 (eccentricity): '00A1254', digits are accepted"},
      {LINE_1 "\n2 27386  98.2753 301.2152 0001254  82.1013 278.0311 24.37874790760346",
       "TLE line 2, columns 53-63 (mean motion): '24.37874790', 1e-08 to 20 rev/day is accepted"},
      {"1 27386U 02009A   16367.75012691  .00000017  00000-0  19645-4 0  9998\n" LINE_2,
       "TLE line 1, columns 21-32 (epoch day of year): '367.75012691', 1 to 367 is accepted"},
      {"1 27386U 02009A   16250.75012691  .00000017  00000-0  1964a-4 0  9994\n" LINE_2,
       "TLE line 1, columns 54-61 (B*): ' 1964a-4', a number like ' 12345-3' for 0.12345e-3 is "
       "accepted"},
      {"1 I7386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9997\n" LINE_2,
       "TLE line 1, columns 3-7 (catalogue number): 'I7386', five digits, or a letter (not I, O) "
       "and four digits (Alpha-5), are accepted"},
      {LINE_1 "\n",
       "TLE: line 2 is missing; two lines that begin with '1 ' and '2 ', with or without a name "
       "line before them, are accepted"},
      {"ENVISAT\n" LINE_1,
       "TLE: line 2 is missing; two lines that begin with '1 ' and '2 ', with or without a name "
       "line before them, are accepted"},
      {LINE_2 "\n",
       "TLE: line 1 is missing; two lines that begin with '1 ' and '2 ', with or without a name "
       "line before them, are accepted"},
      {"",
       "TLE: line 1 is missing; two lines that begin with '1 ' and '2 ', with or without a name "
       "line before them, are accepted"},
      {LINE_2 "\n" LINE_1, "TLE line 1: begins with '2 ', '1 ' is accepted"},
      {LINE_1 "\n" LINE_2 "\n" LINE_1 "\n" LINE_2,
       "TLE: more than three lines; two lines, with or without a name line before them, are "
       "accepted"}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    struct um_orbit_tle tle;
    um_core_message_clear(context);
    assert_int_equal(um_orbit_tle_parse(context, cases[k].text, 1, &tle), UM_ERR_INPUT);
    assert_string_equal(um_core_message(context), cases[k].message);
    assert_null(strchr(um_core_message(context), '\n'));
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(values, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(alpha_5, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(exponent_fields, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
