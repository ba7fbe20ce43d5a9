/* Black-body radiation against printed values and against an independent adaptive quadrature (GSL
 * qag) of Planck's law, which shares nothing with the series but the two radiation constants.
 *
 * The printed table (8-12 um, 150 to 400 K) has 6 decimals of L and 7 digits of the photon
 * radiance: half a unit of the last place is its tolerance. */
#include "base/core/planck.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"

#define FROM 8e-6
#define TO   12e-6

static const struct {
  double temperature, fraction, radiance, exitance, photons, slope, log_slope;
} table[] = {
    {150, 0.037208, 0.339987, 1.068101, 1.807604e19, 0.020801, 9.1771},
    {180, 0.083977, 1.591156, 4.998764, 8.319434e19, 0.068855, 7.7892},
    {200, 0.120538, 3.481021, 10.935949, 1.803490e20, 0.123268, 7.0823},
    {220, 0.157188, 6.646197, 20.879642, 3.416462e20, 0.196267, 6.4968},
    {240, 0.191134, 11.445735, 35.957835, 5.844134e20, 0.286332, 6.0040},
    {250, 0.206499, 14.559301, 45.739393, 7.411518e20, 0.336949, 5.7858},
    {260, 0.220600, 18.195376, 57.162461, 9.236521e20, 0.390765, 5.5838},
    {280, 0.244728, 27.150517, 85.295866, 1.371287e21, 0.506324, 5.2217},
    {300, 0.263341, 38.500424, 120.952649, 1.935962e21, 0.629704, 4.9067},
    {320, 0.276709, 52.370348, 164.526300, 2.623202e21, 0.757847, 4.6307},
    {340, 0.285358, 68.828290, 216.230449, 3.435787e21, 0.888103, 4.3871},
    {360, 0.289926, 87.893912, 276.126870, 4.374206e21, 1.018291, 4.1708},
    {380, 0.291077, 109.547916, 344.154930, 5.437126e21, 1.146691, 3.9776},
    {400, 0.289443, 133.740880, 420.159365, 6.621826e21, 1.272002, 3.8044},
};
#define TABLE_ROWS (sizeof table / sizeof table[0])

/* Planck's law written from the constants, not by the functions under test. */
static double radiance(double wavelength, void *parameters)
{
  double t = *(double *)parameters;
  double x = UM_PLANCK * UM_LIGHT_SPEED / (wavelength * UM_BOLTZMANN * t);
  return 2.0 * UM_PLANCK * UM_LIGHT_SPEED * UM_LIGHT_SPEED / pow(wavelength, 5.0) / expm1(x);
}
static double photons(double wavelength, void *parameters)
{
  return radiance(wavelength, parameters) * wavelength / (UM_PLANCK * UM_LIGHT_SPEED);
}
/* dB/dT = B x e^x / (T (e^x - 1)) */
static double slope(double wavelength, void *parameters)
{
  double t = *(double *)parameters;
  double x = UM_PLANCK * UM_LIGHT_SPEED / (wavelength * UM_BOLTZMANN * t);
  return radiance(wavelength, parameters) * x / (t * -expm1(-x));
}

static double integrate(double (*f)(double, void *), double from, double to, double temperature)
{
  gsl_set_error_handler_off();
  gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(1000);
  assert_non_null(workspace);
  gsl_function function = {f, &temperature};
  double result = NAN, error;
  int code = gsl_integration_qag(&function, from, to, 0.0, 1e-13, 1000, GSL_INTEG_GAUSS61,
                                 workspace, &result, &error);
  gsl_integration_workspace_free(workspace);
  if (code != GSL_SUCCESS && code != GSL_EROUND) fail_msg("qag: %s", gsl_strerror(code));
  return result;
}

/* The derived constants are the exact ones: 2 h c^2, h c / k, 2 pi^5 k^4 / (15 h^3 c^2), to the
 * rounding of the products here; sigma is given with 10 digits. */
static void test_constants(void **state)
{
  (void)state;
  double c1 = 2.0 * UM_PLANCK * UM_LIGHT_SPEED * UM_LIGHT_SPEED;
  double c2 = UM_PLANCK * UM_LIGHT_SPEED / UM_BOLTZMANN;
  assert_close(UM_RADIATION_C1L / c1, 1.0, 4e-16);
  assert_close(UM_RADIATION_C2 / c2, 1.0, 4e-16);
  double sigma = c1 * pow(UM_PI, 5.0) / (15.0 * pow(c2, 4.0));
  assert_close(UM_STEFAN_BOLTZMANN / sigma, 1.0, 1e-10);
}

/* Printed digits of the band fraction; the printed value is rounded to its last place. The second
 * printed maximum, 0.250054, belongs to Wien's 2897.77 um K, not to the rounded 2898 (0.250106). */
static void test_fraction_digits(void **state)
{
  (void)state;
  static const struct {
    double lambda_t; /* [um K] */
    double fraction, half_digit;
  } cases[] = {{1000, 3.207698e-4, 0.5e-10}, {1448, 0.010005, 0.5e-6}, {2897.77, 0.250054, 0.5e-6},
               {4107.3, 0.500009, 0.5e-6},   {5000, 0.633726, 0.5e-6}, {10000, 0.914157, 0.5e-6}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    assert_close(um_core_planck_fraction(cases[i].lambda_t * 1e-6), cases[i].fraction,
                 cases[i].half_digit);
  assert_true(um_core_planck_fraction(0.0) == 0.0);
  assert_true(um_core_planck_fraction(-1.0) == 0.0);
  assert_close(um_core_planck_fraction(10.0), 1.0, 1e-9);
  /* rising, and without a step where the series change at z = 1.5 */
  double before = 0.0;
  for (double z = 40.0; z > 0.01; z *= 0.99) {
    double f = um_core_planck_fraction(UM_RADIATION_C2 / z);
    assert_true(f > before);
    before = f;
  }
  double left = um_core_planck_fraction(UM_RADIATION_C2 / (1.5 * (1.0 + 1e-15)));
  double right = um_core_planck_fraction(UM_RADIATION_C2 / (1.5 * (1.0 - 1e-15)));
  assert_close(left / right, 1.0, 1e-14);
}

static void test_table(void **state)
{
  (void)state;
  for (size_t i = 0; i < TABLE_ROWS; i++) {
    double t = table[i].temperature;
    double l = um_core_planck_band(FROM, TO, t), s = um_core_planck_band_slope(FROM, TO, t);
    double sigma_t4 = UM_STEFAN_BOLTZMANN * t * t * t * t;
    assert_close(l, table[i].radiance, 0.51e-6);
    assert_close(UM_PI * l, table[i].exitance, 0.51e-6);
    assert_close(UM_PI * l / sigma_t4, table[i].fraction, 0.51e-6);
    assert_close(um_core_planck_fraction(TO * t) - um_core_planck_fraction(FROM * t),
                 table[i].fraction, 0.51e-6);
    double unit = pow(10.0, floor(log10(table[i].photons)) - 6.0);
    assert_close(um_core_planck_band_photons(FROM, TO, t), table[i].photons, 0.51 * unit);
    assert_close(s, table[i].slope, 0.51e-6);
    assert_close(s * t / l, table[i].log_slope, 0.51e-4);
  }
}

/* 1e-9 is the accuracy the project promises; quadrature and series each reach about 1e-13. */
static void test_quadrature(void **state)
{
  (void)state;
  static const double bands[][2] = {{8e-6, 12e-6},      {0.38e-6, 0.78e-6}, {3e-6, 5e-6},
                                    {9.99e-6, 10.0e-6}, {20e-6, 200e-6},    {0.4e-6, 0.405e-6}};
  static const double temperatures[] = {150, 200, 220, 280, 300, 400, 1200, 5772, 10000};
  double worst = 0.0;
  for (size_t b = 0; b < 6; b++)
    for (size_t k = 0; k < 9; k++) {
      double from = bands[b][0], to = bands[b][1], t = temperatures[k];
      if (UM_RADIATION_C2 / (to * t) > 100.0) continue; /* below 1e-43 of the total */
      double e0 = um_core_planck_band(from, to, t) / integrate(radiance, from, to, t) - 1.0;
      double e1 = um_core_planck_band_photons(from, to, t) / integrate(photons, from, to, t) - 1.0;
      double e2 = um_core_planck_band_slope(from, to, t) / integrate(slope, from, to, t) - 1.0;
      if (!(fabs(e0) <= 1e-9 && fabs(e1) <= 1e-9 && fabs(e2) <= 1e-9))
        fail_msg("%g to %g m at %g K: radiance %.3g photons %.3g slope %.3g", from, to, t, e0, e1,
                 e2);
      worst = fmax(worst, fmax(fabs(e0), fmax(fabs(e1), fabs(e2))));
    }
  print_message("largest relative difference from quadrature: %.2g\n", worst);
}

static void test_spectral(void **state)
{
  (void)state;
  double t = 300.0;
  for (double um = 0.3; um < 100.0; um *= 1.3)
    assert_close(um_core_planck_radiance(um * 1e-6, t) / radiance(um * 1e-6, &t), 1.0, 1e-13);
  assert_true(um_core_planck_radiance(1e-5, 0.0) == 0.0);
  assert_true(um_core_planck_radiance(1e-7, 2.7) == 0.0); /* underflows, does not overflow */
  /* Wien's displacement law: the maximum is where dB/dlambda changes sign */
  double peak = 2.897771955e-3 / t, h = 1e-4 * peak;
  assert_true(um_core_planck_radiance(peak - h, t) < um_core_planck_radiance(peak, t));
  assert_true(um_core_planck_radiance(peak + h, t) < um_core_planck_radiance(peak, t));
}

/* 5772 K scaled to 1361 W/m^2 gives 632.82 W/m^2 in 0.38-0.78 um, 820.87 in 0.45-1.15 um and 1.298
 * W/m^2 in 8-12 um; half a unit of the printed digits. */
static void test_sun(void **state)
{
  (void)state;
  double t = UM_SOLAR_TEMPERATURE, total = UM_STEFAN_BOLTZMANN * t * t * t * t / UM_PI;
  double scale = UM_SOLAR_IRRADIANCE / total;
  assert_close(scale * um_core_planck_band(0.38e-6, 0.78e-6, t), 632.82, 0.0051);
  assert_close(scale * um_core_planck_band(0.45e-6, 1.15e-6, t), 820.87, 0.0051);
  assert_close(scale * um_core_planck_band(8e-6, 12e-6, t), 1.298, 0.00051);
}

/* Mean radiance of a material at 280 and 220 K with +-10, 20, 40 K, printed in percent to 0.1. */
static void test_mean_temperature_bias(void **state)
{
  (void)state;
  static const double printed[2][3] = {{1.1, 4.4, 17.5}, {3.1, 12.3, 48.9}};
  static const double means[] = {280.0, 220.0}, spread[] = {10.0, 20.0, 40.0};
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 3; j++) {
      double t = means[i], d = spread[j];
      double mean =
          0.5 * (um_core_planck_band(FROM, TO, t - d) + um_core_planck_band(FROM, TO, t + d));
      assert_close(100.0 * (mean / um_core_planck_band(FROM, TO, t) - 1.0), printed[i][j], 0.051);
    }
}

static void test_cold(void **state)
{
  (void)state;
  assert_true(um_core_planck_band(FROM, TO, 0.0) == 0.0);
  assert_true(um_core_planck_band(FROM, TO, -5.0) == 0.0);
  assert_true(um_core_planck_band_slope(FROM, TO, 0.0) == 0.0);
  assert_true(um_core_planck_band_photons(FROM, TO, 0.0) == 0.0);
  double l = um_core_planck_band(FROM, TO, UM_SPACE_TEMPERATURE);
  assert_true(l >= 0.0 && l < 1e-100);
  assert_true(um_core_planck_band_slope(FROM, TO, 0.1) == 0.0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_constants),
      cmocka_unit_test(test_fraction_digits),
      cmocka_unit_test(test_table),
      cmocka_unit_test(test_quadrature),
      cmocka_unit_test(test_spectral),
      cmocka_unit_test(test_sun),
      cmocka_unit_test(test_mean_temperature_bias),

      cmocka_unit_test(test_cold),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
