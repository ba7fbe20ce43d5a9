/* AB magnitudes. Sources: D.1 and D.6 of the physics notes, and the definition. */
#include <math.h>

#include "core/constants.h"
#include "fixture.h"

/* A flat F_nu of 3631 Jy is magnitude 0 in any band; the bins hold its exact mean in the sense of
 * photons, so nothing is left but rounding. */
static void test_flat_spectrum(void **state)
{
  (void)state;
  enum { BINS = 7 };
  double e[BINS], wavelength[BINS], width[BINS], photons = 0.0;
  for (int i = 0; i < BINS; i++) {
    width[i] = 100e-9;
    wavelength[i] = 450e-9 + 100e-9 * (i + 0.5);
    double from = wavelength[i] - 50e-9, to = wavelength[i] + 50e-9;
    /* photons per bin of 3631 Jy: F_0/h ln(to/from), as a constant E over the bin */
    double n = UM_AB_ZERO_JY * 1e-26 / UM_PLANCK * log(to / from);
    e[i] = n * UM_PLANCK * UM_LIGHT_SPEED / (wavelength[i] * width[i]);
    photons += n;
  }
  fixture_close("photons of AB 0 in 450-1150 nm [1/s/m^2]", photons, 5.141595e10, 1e-7);
  assert_true(fabs(um_optics_magnitude_ab(e, wavelength, width, BINS)) < 1e-12);
  for (int i = 0; i < BINS; i++) e[i] *= 1e-2;
  assert_true(fabs(um_optics_magnitude_ab(e, wavelength, width, BINS) - 5.0) < 1e-12);
}

/* Spectral photon rates of AB 0 (D.6): narrow bins, seven printed digits. */
static void test_spectral_photons(void **state)
{
  (void)state;
  const double nm[] = {450.0, 550.0, 650.0, 800.0, 1000.0};
  const double rate[] = {1.217749e8, 9.963399e7, 8.430569e7, 6.849837e7, 5.479870e7};
  for (int i = 0; i < 5; i++) {
    double l = nm[i] * 1e-9, w = 1e-12;
    double e = rate[i] * 1e9 * UM_PLANCK * UM_LIGHT_SPEED / l;
    double m = um_optics_magnitude_ab(&e, &l, &w, 1);
    print_message("AB of %.0f nm photons: %.2g (accepted 3e-7)\n", nm[i], m);
    assert_true(fabs(m) <= 3e-7);
  }
}

/* The Sun in a 380-780 nm top hat: -26.697 by E490 (D.1). The notes integrate E490 as published
 * (1366.09 W/m^2); here it is scaled to that too. 1e-3: printed digits. */
static void test_sun(void **state)
{
  (void)state;
  enum { BINS = 400 };
  static double e[BINS], wavelength[BINS], width[BINS];
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = 1366.09;
  for (int i = 0; i < BINS; i++) {
    width[i] = 1e-9;
    wavelength[i] = (380.5 + i) * 1e-9;
    e[i] = um_environment_solar_band(&environment, wavelength[i] - 0.5e-9, wavelength[i] + 0.5e-9) /
           width[i];
  }
  double m = um_optics_magnitude_ab(e, wavelength, width, BINS);
  print_message("AB magnitude of the Sun in 380-780 nm: %.4f, expected -26.697\n", m);
  assert_true(fabs(m + 26.697) <= 1e-3);
}

static void test_limits(void **state)
{
  (void)state;
  double e = 0.0, l = 0.5e-6, w = 0.1e-6;
  assert_true(isinf(um_optics_magnitude_ab(&e, &l, &w, 1)) &&
              um_optics_magnitude_ab(&e, &l, &w, 1) > 0.0);
  e = -1.0;
  assert_true(isnan(um_optics_magnitude_ab(&e, &l, &w, 1)));
  assert_true(isnan(um_optics_magnitude_ab(&e, &l, &w, 0)));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_flat_spectrum),
      cmocka_unit_test(test_spectral_photons),
      cmocka_unit_test(test_sun),
      cmocka_unit_test(test_limits),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
