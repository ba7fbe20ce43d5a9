/* The function that turns an orbit's error round, against what it stands for, 1/(1 - exp(-x)), from
 * modes that last a million orbits to those that last a millionth of one. It is the nearest of its
 * form: its error comes up to the stated one, with alternating signs, once more than it has numbers
 * to choose (Chebyshev's criterion; six numbers, of which the shift is rounded). */
#include "thermal/solver/orbit_return_group.h"

#include <math.h>

#include "tests/support/cmocka_all.h"

static const double share[] = {UM_THERMAL_RETURN_SHARES};

static double turned_round(double x)
{
  double u = UM_THERMAL_RETURN_SHIFT / (x + UM_THERMAL_RETURN_SHIFT), power = 1.0;
  double sum = 1.0 + 1.0 / x;
  for (int k = 0; k < UM_THERMAL_RETURN_TERMS; k++) sum += share[k] * (power *= u);
  return sum;
}

static void test_error(void **state)
{
  (void)state;
  assert_int_equal(sizeof share / sizeof share[0], UM_THERMAL_RETURN_TERMS);
  double worst = 0.0, peak = 0.0; /* peak: largest since the sign changed */
  int peaks = 0;
  for (double power = -6.0; power <= 6.0; power += 0.001) {
    double x = pow(10.0, power), error = turned_round(x) + 1.0 / expm1(-x);
    if (error * peak < 0.0) {
      if (fabs(peak) > 0.9 * UM_THERMAL_RETURN_ERROR) peaks++;
      peak = 0.0;
    }
    if (fabs(error) > fabs(peak)) peak = error;
    worst = fmax(worst, fabs(error));
  }
  print_message("1/(1 - exp(-x)) within %.3g, %d peaks of that height\n", worst, peaks);
  assert_true(worst <= UM_THERMAL_RETURN_ERROR);
  assert_true(worst >= 0.95 * UM_THERMAL_RETURN_ERROR); /* what is stated is not padded */
  assert_true(peaks >= UM_THERMAL_RETURN_TERMS);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_error)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
