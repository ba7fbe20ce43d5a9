/* AB and Vega magnitudes. Sources: docs/physics/light-curves.md and docs/physics/instrument.md, the
 * definition, and published zero points. */
#include "optics/instrument/photometry.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/environment.h"
#include "optics/instrument/filter.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define BINS 400

static struct um_instrument_bins bins_make(double from, double to, size_t n, double *wavelength,
                                           double *width)
{
  for (size_t i = 0; i < n; i++) {
    width[i] = (to - from) / (double)n;
    wavelength[i] = from + width[i] * ((double)i + 0.5);
  }
  return (struct um_instrument_bins){n, wavelength, width, NULL};
}

/* A flat F_nu of 3631 Jy is magnitude 0 in any band, through any filter; the bins hold its exact
 * mean in the sense of photons, so nothing is left but rounding. */
static void test_flat_spectrum(void **state)
{
  (void)state;
  enum { N = 7 };
  double e[N], wavelength[N], width[N], photons = 0.0;
  const double transmission[N] = {0.0, 0.3, 1.0, 0.9, 0.2, 0.7, 0.01};
  struct um_instrument_bins bins = bins_make(450e-9, 1150e-9, N, wavelength, width);
  for (int i = 0; i < N; i++) {
    double from = wavelength[i] - 50e-9, to = wavelength[i] + 50e-9;
    /* photons per bin of 3631 Jy: F_0/h ln(to/from), as a constant E over the bin */
    double n = UM_AB_ZERO_JY * 1e-26 / UM_PLANCK * log(to / from);
    e[i] = n * UM_PLANCK * UM_LIGHT_SPEED / (wavelength[i] * width[i]);
    photons += n;
  }
  /* of AB 0 in 450-1150 nm, docs/physics/instrument.md */
  assert_close(photons / 5.141595e10, 1.0, 1e-7);
  assert_close(um_instrument_photons(&bins, e) / photons, 1.0, 1e-14);
  assert_close(um_instrument_magnitude_ab(&bins, e), 0.0, 1e-12);
  bins.transmission = transmission;
  assert_close(um_instrument_magnitude_ab(&bins, e), 0.0, 1e-12);
  for (int i = 0; i < N; i++) e[i] *= 1e-2;
  assert_close(um_instrument_magnitude_ab(&bins, e), 5.0, 1e-12);
  double sum = 0.0;
  for (int i = 0; i < N; i++) sum += e[i] * transmission[i] * 100e-9;
  assert_close(um_instrument_irradiance(&bins, e) / sum, 1.0, 1e-14);
}

/* Spectral photon rates of AB 0 (docs/physics/instrument.md): narrow bins, seven printed digits. */
static void test_spectral_photons(void **state)
{
  (void)state;
  const double nm[] = {450.0, 550.0, 650.0, 800.0, 1000.0};
  const double rate[] = {1.217749e8, 9.963399e7, 8.430569e7, 6.849837e7, 5.479870e7};
  for (int i = 0; i < 5; i++) {
    double l = nm[i] * 1e-9, w = 1e-12;
    double e = rate[i] * 1e9 * UM_PLANCK * UM_LIGHT_SPEED / l;
    const struct um_instrument_bins bins = {1, &l, &w, NULL};
    assert_close(um_instrument_magnitude_ab(&bins, &e), 0.0, 3e-7);
  }
}

/* Magnitudes of the Sun by E490 and of Vega through a filter of the program. */
static void through(const char *name, double irradiance, double *sun, double *vega)
{
  struct um_instrument_filter *filter;
  double e[BINS], wavelength[BINS], width[BINS], transmission[BINS];
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = irradiance;
  if (um_instrument_filter_find(context, name, &filter) != UM_OK)
    fail_msg("%s", um_core_message(context));
  struct um_instrument_bins bins =
      bins_make(filter->wavelength[0], filter->wavelength[filter->n - 1], BINS, wavelength, width);
  bins.transmission = transmission;
  for (int i = 0; i < BINS; i++) {
    double from = wavelength[i] - 0.5 * width[i], to = wavelength[i] + 0.5 * width[i];
    transmission[i] = um_instrument_filter_mean(filter, from, to);
    e[i] = um_environment_solar_band(&environment, from, to) / width[i];
  }
  *sun = um_instrument_magnitude_ab(&bins, e);
  *vega = um_instrument_vega_ab(&bins);
  um_instrument_filter_destroy(context, &filter);
}

/* The Sun in a 380-780 nm top hat: -26.697 by E490 (docs/physics/light-curves.md), integrated as
 * published (1366.09 W/m^2). 1e-3: printed digits. */
static void test_sun_in_a_top_hat(void **state)
{
  (void)state;
  double e[BINS], wavelength[BINS], width[BINS];
  struct um_instrument_bins bins = bins_make(380e-9, 780e-9, BINS, wavelength, width);
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = 1366.09;
  for (int i = 0; i < BINS; i++)
    e[i] = um_environment_solar_band(&environment, wavelength[i] - 0.5e-9, wavelength[i] + 0.5e-9) /
           width[i];
  assert_close(um_instrument_magnitude_ab(&bins, e), -26.697, 1e-3);
}

/* The Sun through filters, AB: docs/physics/light-curves.md, and Willmer 2018 (ApJS 236:47), table
 * 3, another solar spectrum and other curves of the same filters (he gives two decimals; 0.03). */
static void test_sun_through_filters(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    double notes, willmer;
  } c[] = {{"johnson_b", NAN, -26.26},     {"johnson_v", -26.765, -26.77},
           {"cousins_r", -26.957, -26.97}, {"sdss_u", NAN, -25.20},
           {"sdss_g", -26.445, -26.45},    {"sdss_r", -26.929, -26.93},
           {"sdss_i", NAN, -27.05},        {"sdss_z", NAN, -27.07}};
  for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
    double sun, vega;
    through(c[i].name, 1366.09, &sun, &vega);
    print_message("the Sun in %s: %.3f, published %.2f\n", c[i].name, sun, c[i].willmer);
    assert_close(sun, c[i].willmer, 0.03);
    if (!isnan(c[i].notes)) assert_close(sun, c[i].notes, 0.01);
  }
}

/* Vega's AB magnitudes: Blanton & Roweis 2007 (AJ 133:734), table 1, and the zero points of Gaia
 * EDR3 (Riello et al. 2021, A&A 649:A3), AB less Vega. 0.04: what calibrations of Vega differ by.
 */
static void test_vega(void **state)
{
  (void)state;
  static const struct {
    const char *name;
    double ab;
  } c[] = {{"johnson_b", -0.09}, {"johnson_v", 0.02}, {"cousins_r", 0.21}, {"cousins_i", 0.45},
           {"sdss_u", 0.91},     {"sdss_g", -0.08},   {"sdss_r", 0.16},    {"sdss_i", 0.37},
           {"sdss_z", 0.54},     {"gaia_g", 0.1136},  {"gaia_bp", 0.0155}, {"gaia_rp", 0.3561}};
  for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
    double sun, vega;
    through(c[i].name, 1361.0, &sun, &vega);
    print_message("Vega in %s: AB %.3f, published %.3f\n", c[i].name, vega, c[i].ab);
    assert_close(vega, c[i].ab, 0.04);
  }
}

static void test_limits(void **state)
{
  (void)state;
  double e = 0.0, l = 0.5e-6, w = 0.1e-6;
  struct um_instrument_bins bins = {1, &l, &w, NULL};
  double none = um_instrument_magnitude_ab(&bins, &e);
  assert_true(isinf(none) && none > 0.0);
  e = -1.0;
  assert_true(isnan(um_instrument_magnitude_ab(&bins, &e)));
  bins.n = 0;
  assert_true(isnan(um_instrument_magnitude_ab(&bins, &e)));
  bins.n = 1;
  l = 0.13e-6; /* 0.08 to 0.18 um */
  assert_true(isnan(um_instrument_vega_ab(&bins)));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_flat_spectrum),
      cmocka_unit_test(test_spectral_photons),
      cmocka_unit_test(test_sun_in_a_top_hat),
      cmocka_unit_test(test_sun_through_filters),
      cmocka_unit_test(test_vega),
      cmocka_unit_test(test_limits),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
