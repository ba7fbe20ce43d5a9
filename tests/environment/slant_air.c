/* Columns of slanted rays and the Sun's light at points of the atmosphere, against sums along the
 * ray, the whole rays of limb_air.h and published airmass. */
#include "environment/slant_air.h"

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "environment/limb_air.h"
#include "tests/environment/check.h"

static struct um_environment_limb_air air;
static struct um_environment_slant slant;

/* Column from a point along a straight line of this zenith angle, in 50 m of way. */
static double by_sum(enum um_environment_limb_constituent which, double height, double zenith_angle)
{
  struct um_environment_limb_profile p = um_environment_limb_standard(UM_LIMB_MIDDLE);
  double r = UM_EARTH_RADIUS + height, u = cos(zenith_angle), sum = 0.0, whole = 0.0;
  for (double z = 25.0; z < 140e3; z += 50.0) whole += 50.0 * p.density(p.self, which, z);
  for (double s = 25.0; s < 2600e3; s += 50.0) {
    double z = sqrt(r * r + s * s + 2.0 * r * s * u) - UM_EARTH_RADIUS;
    sum += 50.0 * p.density(p.self, which, z);
  }
  return sum / whole;
}

static void columns_are_sums_along_the_ray(void **state)
{
  static const double height[] = {0.0, 350.0, 2635.0, 11.3e3, 27.7e3, 52.4e3};
  static const double angle[] = {0.0, 31.0, 66.0, 81.0, 87.3, 89.6, 90.0};
  (void)state;
  double worst = 0.0;
  for (size_t i = 0; i < sizeof height / sizeof height[0]; i++)
    for (size_t k = 0; k < sizeof angle / sizeof angle[0]; k++) {
      double column[UM_LIMB_CONSTITUENTS];
      um_environment_slant_up(&slant, height[i], cos(angle[k] * UM_DEG), column);
      for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
        double sum = by_sum((enum um_environment_limb_constituent)c, height[i], angle[k] * UM_DEG);
        if (sum > 1e-6) worst = fmax(worst, fabs(column[c] / sum - 1.0));
      }
    }
  print_message("worst of 168 columns: %.2f %%\n", 100.0 * worst);
  check_below("columns", worst, 0.006);
}

/* Air and haze of the horizon stand for half a ray of the limb; airmass of Kasten & Young. */
static void meet_the_limb_and_the_airmass(void **state)
{
  double column[UM_LIMB_CONSTITUENTS];
  (void)state;
  um_environment_slant_up(&slant, 0.0, 0.0, column);
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
    check_near("half a ray", 2.0 * column[c] / air.column[c][0], 1.0, 5e-3);
  for (double h = 10.0; h <= 90.0; h += 10.0) {
    um_environment_slant_up(&slant, 0.0, sin(h * UM_DEG), column);
    check_near("airmass", column[UM_LIMB_AIR] / um_environment_airmass(h * UM_DEG), 1.0, 0.01);
  }
}

/* A point 70 km up whose ray passes at 45 km and is hardly bent, and one whose passes at 12 km. */
static void the_sun_comes_through_the_limb(void **state)
{
  double column[UM_LIMB_CONSTITUENTS], dilution = 0.0, z = 70e3;
  (void)state;
  double high = UM_PI - asin((UM_EARTH_RADIUS + 45e3) / (UM_EARTH_RADIUS + z));
  assert_true(um_environment_slant_sun(&slant, z, high, column, &dilution));
  check_near("air", column[UM_LIMB_AIR] / by_sum(UM_LIMB_AIR, z, high), 1.0, 0.01);
  check_near("ozone", column[UM_LIMB_OZONE] / by_sum(UM_LIMB_OZONE, z, high), 1.0, 0.01);
  check_near("not diluted", dilution, 1.0, 0.02);
  /* of an exponential atmosphere 1/(1 + D alpha/H), D the way from the lowest point */
  double low = UM_PI - asin((UM_EARTH_RADIUS + 12e3) / (UM_EARTH_RADIUS + z));
  double bent = air.bending[24], d = -(UM_EARTH_RADIUS + z) * cos(low);
  assert_true(um_environment_slant_sun(&slant, z, low + bent, column, &dilution));
  check_near("lifted", column[UM_LIMB_AIR] / by_sum(UM_LIMB_AIR, z, low), 1.0, 0.02);
  double slope = log(air.bending[23] / air.bending[25]) / (2.0 * UM_LIMB_STEP);
  check_near("diluted", dilution, 1.0 / (1.0 + d * bent * slope), 0.02);
  /* beyond the lowest ray there is shadow */
  double horizon = UM_PI - asin(UM_EARTH_RADIUS / (UM_EARTH_RADIUS + z));
  assert_false(
      um_environment_slant_sun(&slant, z, horizon + 1.05 * air.bending[0], column, &dilution));
  assert_true(
      um_environment_slant_sun(&slant, z, horizon + 0.9 * air.bending[0], column, &dilution));
}

static int begin(void **state)
{
  struct um_environment_limb_profile standard = um_environment_limb_standard(UM_LIMB_MIDDLE);
  (void)state;
  um_environment_limb_air_make(&standard, UM_EARTH_RADIUS, &air);
  um_environment_slant_make(&air, UM_EARTH_RADIUS, &slant);
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(columns_are_sums_along_the_ray),
      cmocka_unit_test(meet_the_limb_and_the_airmass),
      cmocka_unit_test(the_sun_comes_through_the_limb),
  };
  return cmocka_run_group_tests(tests, begin, NULL);
}
