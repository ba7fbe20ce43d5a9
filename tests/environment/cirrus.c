/* Ice crystals against another published set, against what satellites see of cirrus, and a thin
 * cloud in the sky against closed forms. */
#include "environment/cirrus.h"

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/clear_sky.h"
#include "tests/environment/check.h"

/* Hexagonal columns of effective radius 20 um (generalized size 30.79 um): Fu 1996 (J. Climate
 * 9:2058) in the visible, Fu, Yang & Sun 1998 (J. Climate 11:2223) in the infrared, over that at
 * 0.442-0.625 um. Extinction p1 + p2/D + p3/D^2, absorption p4/D + p5 + p6 D + p7 D^2 [m^2/g].
 * Other habits: the two sets differ by 9 %, as published. */
static void test_fu(void **state)
{
  (void)state;
  static const struct {
    double from, to; /* [1/cm] */
    double p[7];
  } band[] = {
      {700,
       820,
       {-0.004159424, 3.047325, -5.061568, 1.466481, -0.002129226, -1.36163e-5, 1.193649e-7}},
      {820,
       980,
       {-0.001691632, 2.765756, -8.331033, 1.195515, 0.003350616, -5.266996e-5, 2.233377e-7}},
      {980,
       1080,
       {-0.008372696, 3.455018, -15.16692, 0.5409536, 0.01949649, -2.050908e-4, 7.36468e-7}},
      {1080,
       1180,
       {-0.008178608, 3.401245, -8.81282, 0.5874323, 0.01876628, -2.045834e-4, 7.51008e-7}},
      {1180,
       1390,
       {-0.00493661, 3.087764, -3.884262, 0.7152274, 0.01621734, -1.868544e-4, 7.078738e-7}},
  };
  const double d = 8.0 / (3.0 * sqrt(3.0)) * 20.0, visible = 0.0817647; /* [um], [m^2/g] */
  for (size_t i = 0; i < sizeof band / sizeof band[0]; i++) {
    const double *p = band[i].p;
    double extinction = (p[0] + p[1] / d + p[2] / (d * d)) / visible;
    double absorption = (p[3] / d + p[4] + p[5] * d + p[6] * d * d) / visible;
    struct um_environment_ice mean = {0.0, 0.0};
    const int n = 40;
    for (int k = 0; k < n; k++) {
      double wave = band[i].from + (band[i].to - band[i].from) * (k + 0.5) / n;
      struct um_environment_ice ice = um_environment_ice_at(1e-2 / wave);
      mean.extinction += ice.extinction / n;
      mean.absorption += ice.absorption / n;
    }
    print_message("%g-%g 1/cm: extinction %.3f (Fu %.3f), absorption %.3f (Fu %.3f)\n",
                  band[i].from, band[i].to, mean.extinction, extinction, mean.absorption,
                  absorption);
    assert_true(fabs(mean.extinction / extinction - 1.0) <= 0.09);
    assert_true(fabs(mean.absorption / absorption - 1.0) <= 0.10);
  }
}

/* Optical depth of thin cirrus in the visible is 1.8 to 2.2 times that of absorption at 12.05 um,
 * as CALIPSO's lidar and imager see it (Garnier et al. 2012, J. Appl. Meteorol. Climatol. 51:1407).
 * Its extinction has its minimum at 10.5 um (Arnott et al. 1995, Appl. Opt. 34:541). */
static void test_seen(void **state)
{
  (void)state;
  double ratio = 1.0 / um_environment_ice_at(12.05e-6).absorption;
  print_message("visible over 12.05 um: %.2f\n", ratio);
  assert_true(ratio >= 1.8 && ratio <= 2.2);
  double least = 1e9, where = 0.0;
  for (double l = 7.0e-6; l < 14.5e-6; l += 0.05e-6)
    if (um_environment_ice_at(l).extinction < least)
      least = um_environment_ice_at(l).extinction, where = l;
  assert_true(fabs(where - 10.5e-6) <= 0.3e-6);
  assert_close(um_environment_ice_at(0.55e-6).extinction, 1.0, 0.0);
  assert_close(um_environment_ice_at(20e-6).absorption, 0.509, 0.0);
}

/* Where there is nothing else (no water, ozone, gases): the visible loses e^(-c x), 10 um loses by
 * extinction and glows as a grey layer of the cloud's temperature by absorption. Below a black
 * ground layer nothing of the cloud is seen; ozone behind it glows through what it absorbs. */
static void test_alone(void **state)
{
  (void)state;
  struct um_environment_clear_sky sky = um_environment_clear_sky_of(UM_SKY_US_STANDARD, 0.0);
  const double at = 10e-6, half = 1e-10, x = 2.0;
  struct um_environment_ice ice = um_environment_ice_at(at);
  struct um_environment_clear_sky clear = sky;
  sky.cirrus = 0.2;
  double with = um_environment_clear_sky_transmission(&sky, 0.55e-6 - half, 0.55e-6 + half, x);
  double without = um_environment_clear_sky_transmission(&clear, 0.55e-6 - half, 0.55e-6 + half, x);
  assert_close(with / without, exp(-0.4), 1e-12);
  with = um_environment_clear_sky_transmission(&sky, at - half, at + half, x);
  without = um_environment_clear_sky_transmission(&clear, at - half, at + half, x);
  assert_close(with / without, exp(-0.4 * ice.extinction), 1e-6);

  double ozone = um_environment_clear_sky_radiance(&clear, at - half, at + half, x);
  sky.water = sky.pressure = clear.water = clear.pressure = 0.0;
  ozone = um_environment_clear_sky_radiance(&clear, at - half, at + half, x);
  double a = exp(-0.4 * ice.absorption);
  double glow = um_environment_clear_sky_radiance(&sky, at - half, at + half, x);
  double expected = a * ozone + (1.0 - a) * um_core_planck_radiance(at, sky.cirrus_temperature);
  assert_close(glow / expected, 1.0, 1e-5);

  sky.water = clear.water = 1e5;
  assert_close(um_environment_clear_sky_radiance(&sky, at - half, at + half, x) /
                   um_environment_clear_sky_radiance(&clear, at - half, at + half, x),
               1.0, 1e-12);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_fu), cmocka_unit_test(test_seen),
                                     cmocka_unit_test(test_alone)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
