/* Black bodies in 8-12 um, band fractions, AB magnitudes, airmass.
 *
 * Sources: Planck's law by adaptive quadrature (expected values of 8-12 um: half of the last
 * printed digit is the tolerance); Oke & Gunn 1983; ASTM E490; Kasten & Young 1989. */
#include <math.h>

#include "app/validate/cases_impl.h"
#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/airmass.h"
#include "environment/environment.h"
#include "optics/instrument/photometry.h"

#define PLANCK "Planck's law"

/* Half digits: of seven in the photons, of six decimals elsewhere; 0.51 for their own rounding. */
static void band_table(struct um_validate_report *report)
{
#define ROW(t, l, n, s)                                                                            \
  {                                                                                                \
    t, {l, n, s},                                                                                  \
    {                                                                                              \
      "8-12 um radiance at " #t " K", "8-12 um photon radiance at " #t " K",                       \
          "8-12 um radiance slope at " #t " K"                                                     \
    }                                                                                              \
  }
  static const struct {
    double temperature, expected[3];
    const char *name[3];
  } row[] = {
      ROW(150, 0.339987, 1.807604e19, 0.020801),   ROW(180, 1.591156, 8.319434e19, 0.068855),
      ROW(200, 3.481021, 1.803490e20, 0.123268),   ROW(220, 6.646197, 3.416462e20, 0.196267),
      ROW(240, 11.445735, 5.844134e20, 0.286332),  ROW(250, 14.559301, 7.411518e20, 0.336949),
      ROW(260, 18.195376, 9.236521e20, 0.390765),  ROW(280, 27.150517, 1.371287e21, 0.506324),
      ROW(300, 38.500424, 1.935962e21, 0.629704),  ROW(320, 52.370348, 2.623202e21, 0.757847),
      ROW(340, 68.828290, 3.435787e21, 0.888103),  ROW(360, 87.893912, 4.374206e21, 1.018291),
      ROW(380, 109.547916, 5.437126e21, 1.146691), ROW(400, 133.740880, 6.621826e21, 1.272002)};
#undef ROW
  static const char *const unit[3] = {"W/m^2/sr", "1/s/m^2/sr", "W/m^2/sr/K"};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double t = row[i].temperature;
    double digit = pow(10.0, floor(log10(row[i].expected[1])) - 6.0);
    const double value[3] = {um_core_planck_band(8e-6, 12e-6, t),
                             um_core_planck_band_photons(8e-6, 12e-6, t),
                             um_core_planck_band_slope(8e-6, 12e-6, t)};
    const double tolerance[3] = {0.51e-6, 0.51 * digit, 0.51e-6};
    for (int k = 0; k < 3; k++)
      um_validate_report_add(report, row[i].name[k], unit[k], row[i].expected[k], value[k],
                             tolerance[k], PLANCK);
  }
}

/* The same radiance by Simpson's rule on Planck's law, 4000 intervals: 1e-12; held to 1e-9. */
static void band_quadrature(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double temperature;
  } row[] = {{"8-12 um radiance over quadrature, 150 K", 150.0},
             {"8-12 um radiance over quadrature, 280 K", 280.0},
             {"8-12 um radiance over quadrature, 400 K", 400.0}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double sum = 0.0;
    for (int k = 0; k <= 4000; k++) {
      double l = 8e-6 + 1e-9 * k, x = UM_PLANCK * UM_LIGHT_SPEED / (l * UM_BOLTZMANN);
      double b = 2.0 * UM_PLANCK * UM_LIGHT_SPEED * UM_LIGHT_SPEED /
                 (pow(l, 5.0) * expm1(x / row[i].temperature));
      sum += b * (k == 0 || k == 4000 ? 1.0 : k % 2 ? 4.0 : 2.0) * 1e-9 / 3.0;
    }
    um_validate_report_add(report, row[i].name, "1", 1.0,
                           um_core_planck_band(8e-6, 12e-6, row[i].temperature) / sum, 1e-9,
                           PLANCK);
  }
}

/* F(0 to lambda T), six decimals; the maximum of B at Wien's 2897.772 um K. */
static void fractions(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double lambda_t, expected, tolerance; /* [m K] */
  } row[] = {{"Fraction below 1000 um K", 1000e-6, 3.207698e-4, 0.51e-10},
             {"Fraction below 1448 um K", 1448e-6, 0.010005, 0.51e-6},
             {"Fraction below 2897.77 um K", 2897.77e-6, 0.250054, 0.51e-6},
             {"Fraction below 4107.3 um K", 4107.3e-6, 0.500009, 0.51e-6},
             {"Fraction below 5000 um K", 5000e-6, 0.633726, 0.51e-6},
             {"Fraction below 10000 um K", 10000e-6, 0.914157, 0.51e-6}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    um_validate_report_add(report, row[i].name, "1", row[i].expected,
                           um_core_planck_fraction(row[i].lambda_t), row[i].tolerance,
                           "Chang & Rhee 1984");
}

/* Photon rate of AB 0 from the magnitude of a unit irradiance; seven digits are printed. */
static void ab_photons(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double wavelength, rate; /* [m], [1/s/m^2/nm] */
  } row[] = {{"Photons of AB 0 at 450 nm", 450e-9, 1.217749e8},
             {"Photons of AB 0 at 550 nm", 550e-9, 9.963399e7},
             {"Photons of AB 0 at 650 nm", 650e-9, 8.430569e7},
             {"Photons of AB 0 at 800 nm", 800e-9, 6.849837e7},
             {"Photons of AB 0 at 1000 nm", 1000e-9, 5.479870e7}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double e = 1.0, l = row[i].wavelength, width = 1e-12;
    const struct um_instrument_bins bins = {1, &l, &width, NULL};
    double zero = pow(10.0, 0.4 * um_instrument_magnitude_ab(&bins, &e)); /* [W/m^2/m] */
    double digit = pow(10.0, floor(log10(row[i].rate)) - 6.0);
    um_validate_report_add(report, row[i].name, "1/s/m^2/nm", row[i].rate,
                           1e-9 * zero * l / (UM_PLANCK * UM_LIGHT_SPEED), 0.51 * digit,
                           "Oke & Gunn 1983");
  }
}

/* AB magnitude of E490 in a top hat of 380-780 nm, photon counting; the reference takes the
 * spectrum as published, 1366.09 W/m^2. Three decimals. */
static void ab_sun(struct um_validate_report *report)
{
  enum { BINS = 400 };
  double e[BINS], wavelength[BINS], width[BINS];
  const struct um_instrument_bins bins = {BINS, wavelength, width, NULL};
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = 1366.09;
  for (int i = 0; i < BINS; i++) {
    width[i] = 1e-9;
    wavelength[i] = (380.5 + i) * 1e-9;
    e[i] = um_environment_solar_band(&environment, wavelength[i] - 0.5e-9, wavelength[i] + 0.5e-9) /
           width[i];
  }
  um_validate_report_add(report, "AB magnitude of the Sun, 380-780 nm", "mag", -26.697,
                         um_instrument_magnitude_ab(&bins, e), 1e-3, "ASTM E490");
}

static void airmass(struct um_validate_report *report)
{
  static const struct {
    const char *name;
    double elevation, expected, tolerance; /* printed digits */
  } row[] = {{"Airmass at 90 deg", 90.0, 0.99971, 5e-6}, {"Airmass at 60 deg", 60.0, 1.15399, 5e-6},
             {"Airmass at 45 deg", 45.0, 1.4126, 5e-5},  {"Airmass at 30 deg", 30.0, 1.99429, 5e-6},
             {"Airmass at 20 deg", 20.0, 2.90315, 5e-6}, {"Airmass at 10 deg", 10.0, 5.58604, 5e-6},
             {"Airmass at 5 deg", 5.0, 10.30579, 5e-6}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
    um_validate_report_add(report, row[i].name, "1", row[i].expected,
                           um_environment_airmass(row[i].elevation * UM_DEG), row[i].tolerance,
                           "Kasten & Young 1989");
}

enum um_status um_validate_radiometry(struct um_context *context, struct um_validate_report *report)
{
  (void)context;
  band_table(report);
  band_quadrature(report);
  fractions(report);
  ab_photons(report);
  ab_sun(report);
  airmass(report);
  return UM_OK;
}
