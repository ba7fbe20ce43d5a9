/* Counts and noise: docs/physics/instrument.md and docs/physics/noise.md, and limits that have
 * closed forms. */
#include "optics/instrument/sensor.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "base/core/planck.h"
#include "tests/support/cmocka_all.h"

#define BINS 700

/* 450-1150 nm in nanometres, with the quantum efficiency of the notes' section E. */
struct band {
  double wavelength[BINS], width[BINS], efficiency[BINS];
};

static struct um_instrument_bins bins_make(struct band *b, double throughput)
{
  static const double nm[] = {450, 500, 550, 600,  650,  700,  750, 800,
                              850, 900, 950, 1000, 1050, 1100, 1150};
  static const double qe[] = {.50, .55, .585, .60, .57, .52,  .45, .36,
                              .28, .19, .11,  .05, .02, .005, 0};
  for (int i = 0; i < BINS; i++) {
    double at = 450.5 + i;
    b->wavelength[i] = at * 1e-9;
    b->width[i] = 1e-9;
    b->efficiency[i] = throughput * um_core_interpolate(nm, qe, 15, at);
  }
  return (struct um_instrument_bins){BINS, b->wavelength, b->width, b->efficiency};
}

/* The Sun, a black body of 5772 K and 1361 W/m^2, dimmed from -26.74 to a magnitude. */
static void sun_of_magnitude(const struct band *b, double magnitude, double *spectral)
{
  double all = UM_STEFAN_BOLTZMANN * pow(5772.0, 4) / UM_PI;
  for (int i = 0; i < BINS; i++)
    spectral[i] =
        1361.0 / all * pow(10.0, -0.4 * (magnitude + 26.74)) *
        um_core_planck_band(b->wavelength[i] - 0.5e-9, b->wavelength[i] + 0.5e-9, 5772.0) / 1e-9;
}

static struct um_instrument_sensor ufo(void)
{
  return (struct um_instrument_sensor){.aperture = 0.43,
                                       .obstruction =
                                           sqrt(1.0 - 0.1121 / (0.25 * UM_PI * 0.43 * 0.43)),
                                       .gain = 1.0,
                                       .pixel = 0.456,
                                       .fwhm = 2.0,
                                       .radius = 1.0,
                                       .annulus = INFINITY,
                                       .sky = INFINITY,
                                       .saturation = INFINITY,
                                       .noise_equivalent_irradiance = NAN};
}

/* docs/physics/instrument.md: m = 6 of solar colour through 0.1121 m^2 and a throughput of
 * 0.7: 6.699e6 e/s; through 0.20 m with 0.3 of its diameter obstructed 1.708e6. Four digits; the
 * notes' sums are coarser. */
static void test_count_rates(void **state)
{
  (void)state;
  static struct band b;
  static double spectral[BINS];
  struct um_instrument_bins bins = bins_make(&b, 0.7);
  struct um_instrument_sensor s = ufo();
  sun_of_magnitude(&b, 6.0, spectral);
  assert_close(um_instrument_area(&s), 0.1121, 1e-12);
  assert_close(um_instrument_count_rate(&s, &bins, spectral) / 6.699e6, 1.0, 3e-4);
  s.gain = 0.45;
  assert_close(um_instrument_count_rate(&s, &bins, spectral) * 0.45 / 6.699e6, 1.0, 3e-4);
  s.gain = 1.0;
  s.aperture = 0.20;
  s.obstruction = 0.3;
  assert_close(um_instrument_count_rate(&s, &bins, spectral) / 1.708e6, 1.0, 5e-4);
}

/* docs/physics/noise.md: S 1e4, B 5, D 0.1, R 1.2, t 1, n 78.5, n_a 400 -> 97.0639; S 100
 * -> 3.7420. */
static void test_ccd_equation(void **state)
{
  (void)state;
  static struct band b;
  struct um_instrument_bins bins = bins_make(&b, 0.7);
  struct um_instrument_sensor s = ufo();
  s.radius = 3.0; /* all of a Gaussian but 1.5e-11 */
  s.fwhm = 3.0;
  s.pixel = s.radius * s.fwhm * sqrt(UM_PI / 78.5);
  s.annulus = 400.0;
  s.read_noise = 1.2;
  s.dark = 0.1;
  double sky = 5.0 / (s.pixel * s.pixel); /* [e/s/arcsec^2] */
  s.sky = -2.5 * log10(sky / um_instrument_count_rate_ab0(&s, &bins));
  struct um_instrument_exposure e = um_instrument_expose(&s, &bins, 1e4, NAN, 0.0, 1.0);
  assert_close(e.snr, 97.0639, 1e-4);
  assert_close(e.background, 78.5 * 5.1, 1e-9);
  assert_close(um_instrument_expose(&s, &bins, 100.0, NAN, 0.0, 1.0).snr, 3.7420, 1e-4);
  /* a source of the limiting magnitude has SNR 5 */
  double rate = um_instrument_count_rate_ab0(&s, &bins) * pow(10.0, -0.4 * e.limit_ab);
  assert_close(um_instrument_expose(&s, &bins, rate, NAN, 0.0, 1.0).snr, 5.0, 1e-9);
  assert_close(um_instrument_expose(&s, &bins, 0.0, NAN, 0.0, 1.0).snr, 0.0, 0.0);
}

/* docs/physics/noise.md: encircled energy 0.5, 0.9375, 0.998047 at 0.5, 1, 1.5 FWHM; photons alone
 * leave sqrt(S). */
static void test_encircled(void **state)
{
  (void)state;
  static struct band b;
  struct um_instrument_bins bins = bins_make(&b, 1.0);
  const double q[] = {0.5, 1.0, 1.5}, share[] = {0.5, 0.9375, 0.998046875};
  struct um_instrument_sensor s = ufo();
  s.gain = 2.0;
  for (int i = 0; i < 3; i++) {
    s.radius = q[i];
    struct um_instrument_exposure e = um_instrument_expose(&s, &bins, 1000.0, NAN, 0.0, 3.0);
    assert_close(e.signal, 6000.0 * share[i], 1e-9);
    assert_close(e.snr, sqrt(6000.0 * share[i]), 1e-9);
  }
}

/* A Gaussian on the middle of a pixel, integrated plainly; what a pixel cannot hold is said. */
static void test_peak(void **state)
{
  (void)state;
  static struct band b;
  struct um_instrument_bins bins = bins_make(&b, 1.0);
  struct um_instrument_sensor s = ufo();
  double sigma = s.fwhm / 2.354820045, sum = 0.0;
  enum { N = 400 };
  for (int i = 0; i < N * N; i++) {
    double x = s.pixel * ((i % N + 0.5) / N - 0.5), y = s.pixel * ((i / N + 0.5) / N - 0.5);
    sum += exp(-0.5 * (x * x + y * y) / (sigma * sigma));
  }
  sum *= s.pixel * s.pixel / (N * N) / (2.0 * UM_PI * sigma * sigma);
  s.dark = 7.0;
  struct um_instrument_exposure e = um_instrument_expose(&s, &bins, 1e5, NAN, 0.0, 2.0);
  assert_close(e.peak / (2e5 * sum + 14.0), 1.0, 1e-6);
  assert_false(e.saturated);
  s.saturation = e.peak * 0.999;
  assert_true(um_instrument_expose(&s, &bins, 1e5, NAN, 0.0, 2.0).saturated);
}

/* Where the core of the image asks for more than a pixel holds, what is found is the integral of
 * min(s(r), c) over rings, s a Gaussian that gives the central pixel its share; below it, all. */
static void test_saturated(void **state)
{
  (void)state;
  static struct band b;
  struct um_instrument_bins bins = bins_make(&b, 1.0);
  struct um_instrument_sensor s = ufo();
  s.dark = 50.0;
  struct um_instrument_exposure e = um_instrument_expose(&s, &bins, 1e5, NAN, 0.0, 2.0);
  double background = um_instrument_pixel_background(&s, &bins, 0.0, 2.0);
  double central = (e.peak - background) / 2e5, room = 3000.0;
  assert_close(background, 100.0, 1e-9);
  s.saturation = room + background;
  const double electrons[] = {1e3, 0.999 * room / central, 2e5, 3e6};
  for (size_t i = 0; i < sizeof electrons / sizeof electrons[0]; i++) {
    double sum = 0.0, step = 1e-4; /* of x = r^2/(2 sigma^2), dS = g S exp(-x) dx / g */
    for (double x = 0.5 * step; x < 40.0; x += step)
      sum += fmin(central * electrons[i] * exp(-x), room) / central * step;
    double found = um_instrument_saturated(&s, electrons[i], background);
    assert_close(found / sum, 1.0, 1e-6);
    if (i < 2) assert_true(found == electrons[i]);
    assert_close(um_instrument_unsaturated(&s, found, background) / electrons[i], 1.0, 1e-12);
  }
  assert_true(um_instrument_saturated(&s, 1e3, 4000.0) == 0.0);
  e = um_instrument_expose(&s, &bins, 1e5, NAN, 0.0, 2.0);
  assert_true(e.saturated && e.peak == s.saturation);
  s.pixel = NAN;
  assert_true(isnan(um_instrument_pixel_background(&s, &bins, 0.0, 2.0)));
}

/* A thermal imager is rated by the irradiance that equals its noise; without pixels nothing else is
 * known. */
static void test_noise_equivalent(void **state)
{
  (void)state;
  static struct band b;
  struct um_instrument_bins bins = bins_make(&b, 1.0);
  struct um_instrument_sensor s = ufo();
  s.pixel = NAN;
  s.noise_equivalent_irradiance = 4.53e-10;
  struct um_instrument_exposure e = um_instrument_expose(&s, &bins, 10.0, 9.06e-10, 0.0, 1.0);
  assert_close(e.snr, 2.0, 1e-12);
  assert_true(isnan(e.background) && isnan(e.peak) && isnan(e.limit_ab) && !e.saturated);
}

/* docs/physics/noise.md: D 0.432, t 1, X 1, h 350 -> 0.00795; t 0.1, X 2.9 -> 0.124. */
static void test_scintillation(void **state)
{
  (void)state;
  assert_close(um_instrument_scintillation(0.432, 1.0, 1.0, 350.0), 0.00795, 5e-6);
  assert_close(um_instrument_scintillation(0.432, 0.1, 2.9, 350.0), 0.124, 5e-4);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_count_rates),   cmocka_unit_test(test_ccd_equation),
      cmocka_unit_test(test_encircled),     cmocka_unit_test(test_peak),
      cmocka_unit_test(test_saturated),     cmocka_unit_test(test_noise_equivalent),
      cmocka_unit_test(test_scintillation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
