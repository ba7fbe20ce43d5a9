/* Relative optical airmass against the table of Kasten & Young (1989, Appl. Opt. 28:4735, Table
 * II), which integrates the ISO standard atmosphere of 1972; their formula fits it to 0.5 %, so
 * that the answers are those of the formula, printed to six digits. */
#include "environment/airmass.h"

#include "core/constants.h"
#include "tests/support/cmocka_all.h"

static void test_table(void **state)
{
  (void)state;
  static const double row[][2] = {{90.0, 0.99971}, {60.0, 1.15399}, {45.0, 1.4126}, {30.0, 1.99429},
                                  {20.0, 2.90315}, {10.0, 5.58604}, {5.0, 10.30579}};
  for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
    double airmass = um_environment_airmass(row[i][0] * UM_DEG);
    print_message("elevation %.0f deg: airmass %.6g, printed %.6g\n", row[i][0], airmass,
                  row[i][1]);
    assert_true(fabs(airmass - row[i][1]) <= 5.1e-6 * row[i][1]);
  }
}

/* At the horizon nearly 38 (their value 37.92); below it there is no path through the air alone. */
static void test_horizon(void **state)
{
  (void)state;
  assert_true(fabs(um_environment_airmass(0.0) - 37.92) <= 0.01);
  assert_true(isnan(um_environment_airmass(-1e-9)));
  assert_true(isnan(um_environment_airmass(NAN)));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_table), cmocka_unit_test(test_horizon)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
