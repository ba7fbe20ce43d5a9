/* Interpolation: exact for the functions each rule stands for, so tolerances are rounding. */
#include "base/core/interpolation.h"

#include <math.h>

#include "tests/support/cmocka_all.h"

static const double X[] = {0.0, 1.0, 3.0, 7.0};
static const double Y[] = {2.0, 4.0, 0.0, -8.0};

static void test_interval(void **state)
{
  (void)state;
  assert_int_equal(um_core_interval_find(X, 4, -1.0), 0);
  assert_int_equal(um_core_interval_find(X, 4, 0.0), 0);
  assert_int_equal(um_core_interval_find(X, 4, 0.999), 0);
  assert_int_equal(um_core_interval_find(X, 4, 1.0), 1);
  assert_int_equal(um_core_interval_find(X, 4, 3.0), 2);
  assert_int_equal(um_core_interval_find(X, 4, 7.0), 2);
  assert_int_equal(um_core_interval_find(X, 4, 99.0), 2);
  assert_int_equal(um_core_interval_find(X, 2, 0.5), 0);
}

static void test_linear(void **state)
{
  (void)state;
  assert_close(um_core_interpolate(X, Y, 4, 0.5), 3.0, 1e-15);
  assert_close(um_core_interpolate(X, Y, 4, 2.0), 2.0, 1e-15);
  assert_close(um_core_interpolate(X, Y, 4, 5.0), -4.0, 1e-15);
  assert_close(um_core_interpolate(X, Y, 4, 3.0), 0.0, 0.0);
  assert_close(um_core_interpolate(X, Y, 4, -5.0), 2.0, 0.0);
  assert_close(um_core_interpolate(X, Y, 4, 50.0), -8.0, 0.0);
  assert_close(um_core_interpolate(X, Y, 1, 50.0), 2.0, 0.0);
}

/* exp(a x) is straight in log y. */
static void test_log(void **state)
{
  (void)state;
  double y[4];
  for (int i = 0; i < 4; i++) y[i] = 3.0 * exp(-2.0 * X[i]);
  for (double v = 0.0; v <= 7.0; v += 0.37)
    assert_close(um_core_interpolate_log(X, y, 4, v) / (3.0 * exp(-2.0 * v)), 1.0, 1e-14);
  assert_close(um_core_interpolate_log(X, Y, 4, 2.0), 2.0, 1e-15); /* ends in 0: linear */
  assert_close(um_core_interpolate_log(X, y, 4, -1.0), y[0], 0.0);
  assert_close(um_core_interpolate_log(X, y, 4, 8.0), y[3], 0.0);
}

/* Areas of trapezoids by hand: 3 + 4 - 16 over the whole table. */
static void test_integral(void **state)
{
  (void)state;
  assert_close(um_core_integrate_linear(X, Y, 4, 0.0, 7.0), -9.0, 1e-14);
  assert_close(um_core_integrate_linear(X, Y, 4, -10.0, 70.0), -9.0, 1e-14);
  assert_close(um_core_integrate_linear(X, Y, 4, 0.5, 2.0), 1.75 + 3.0, 1e-14);
  assert_close(um_core_integrate_linear(X, Y, 4, 1.5, 2.5), 2.0, 1e-14);
  assert_close(um_core_integrate_linear(X, Y, 4, 8.0, 9.0), 0.0, 0.0);
  assert_close(um_core_integrate_linear(X, Y, 4, 2.0, 2.0), 0.0, 0.0);
  assert_close(um_core_integrate_linear(X, Y, 1, 0.0, 2.0), 0.0, 0.0);
  /* additive over a split anywhere */
  for (double m = 0.0; m <= 7.0; m += 0.31)
    assert_close(um_core_integrate_linear(X, Y, 4, 0.0, m) +
                     um_core_integrate_linear(X, Y, 4, m, 7.0),
                 -9.0, 1e-14);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_interval),
      cmocka_unit_test(test_linear),
      cmocka_unit_test(test_log),
      cmocka_unit_test(test_integral),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
