/* Sunlight: irradiance with distance, black body and ASTM E490 bands. */
#include <string.h>

#include "base/core/constants.h"
#include "check.h"
#include "environment/environment.h"
#include "tests/support/reference.h"

static struct um_environment with(enum um_environment_spectrum spectrum, double irradiance)
{
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.spectrum = spectrum;
  environment.solar_irradiance = irradiance;
  return environment;
}

/* 1361 W/m^2 (Kopp & Lean 2011) over r^2 at perihelion, aphelion and on 2016-09-21; printed to
 * 0.01 W/m^2, distances to 1e-5 au. */
static void irradiance_falls_with_the_square(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SPECTRUM_E490, 1361.0);
  check_near("1 au", um_environment_solar_irradiance(&e, UM_AU), 1361.0, 1e-9);
  check_near("2016-09-21", um_environment_solar_irradiance(&e, 1.0037221 * UM_AU), 1350.92, 0.005);
  check_near("perihelion", um_environment_solar_irradiance(&e, 0.98329 * UM_AU), 1407.65, 0.02);
  check_near("aphelion", um_environment_solar_irradiance(&e, 1.01671 * UM_AU), 1316.63, 0.02);
}

/* Planck's law at 5772 K scaled to 1361 W/m^2: numerical quadrature, printed digits. */
static void black_body_bands(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SPECTRUM_BLACK_BODY, 1361.0);
  check_near("0.38-0.78 um", um_environment_solar_band(&e, 0.38e-6, 0.78e-6), 632.82, 0.005);
  check_near("0.45-1.15 um", um_environment_solar_band(&e, 0.45e-6, 1.15e-6), 820.87, 0.005);
  check_near("8-12 um", um_environment_solar_band(&e, 8e-6, 12e-6), 1.298, 0.0005);
  check_near("below 2.5 um", um_environment_solar_band(&e, 0.0, 2.5e-6) / 1361.0, 0.965644, 5e-7);
  check_near("all", um_environment_solar_band(&e, 0.0, 1.0), 1361.0, 1e-6);
}

/* The spectrum itself: 140 midpoints of 5 nm over 0.45-1.15 um. A Sun of 5772 K gives 1361.16 W/m^2
 * unscaled, sigma T^4 (R_sun / au)^2, and then 820.97 W/m^2 by this rule (printed digits); its
 * error, h^2/24 times the difference of end slopes, is 6e-3. */
static void black_body_midpoints(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SPECTRUM_BLACK_BODY, 1361.16);
  double sum = 0.0;
  for (int i = 0; i < 140; i++)
    sum += 5e-9 * um_environment_solar_spectrum(&e, 0.45e-6 + 5e-9 * (i + 0.5));
  check_near("midpoints", sum, 820.97, 0.005);
  check_near("against the band", sum, um_environment_solar_band(&e, 0.45e-6, 1.15e-6), 0.008);
}

/* The standard, linear between its own points, integrates to 1366.0908 W/m^2 and in 0.38-0.78 um to
 * 654.9465. (653.18, also met in print, is the trapezoid from its first point inside the band to
 * its last, 0.3805-0.779 um.) The band limits are edges of cells: exact but for six digits a value.
 */
static void standard_bands(void **state)
{
  (void)state;
  struct um_environment own = with(UM_SPECTRUM_E490, 1366.0908);
  check_near("0.38-0.78 um", um_environment_solar_band(&own, 0.38e-6, 0.78e-6), 654.9465, 2e-3);
  /* limits inside cells: the structure of two 5 nm cells, below 1e-4 of the band */
  check_near("0.3805-0.779 um", um_environment_solar_band(&own, 0.3805e-6, 0.779e-6), 653.1755,
             0.065);
  check_near("0.45-1.15 um", um_environment_solar_band(&own, 0.45e-6, 1.15e-6), 849.5357, 0.02);
  check_near("8-12 um", um_environment_solar_band(&own, 8e-6, 12e-6), 1.095933, 1e-5);
  struct um_environment e = with(UM_SPECTRUM_E490, 1361.0);
  /* 654.9465 * 1361 / 1366.0908 */
  check_near("scaled", um_environment_solar_band(&e, 0.38e-6, 0.78e-6), 652.5058, 2e-3);
  check_near("total", um_environment_solar_band(&e, 0.0, 1.0), 1361.0, 1e-9);
}

/* The band is the integral of the spectrum: fine midpoints of a piecewise linear curve. */
static void band_is_the_integral_of_the_spectrum(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SPECTRUM_E490, 1361.0);
  const int n = 400000;
  double from = 0.387e-6, to = 0.7113e-6, sum = 0.0;
  for (int i = 0; i < n; i++)
    sum += um_environment_solar_spectrum(&e, from + (to - from) * (i + 0.5) / n);
  check_near("band", um_environment_solar_band(&e, from, to), sum * (to - from) / n, 1e-6);
  double parts = 0.0;
  for (int i = 0; i < 77; i++)
    parts += um_environment_solar_band(&e, from + (to - from) * i / 77,
                                       from + (to - from) * (i + 1) / 77);
  check_near("sum of bins", parts, um_environment_solar_band(&e, from, to), 1e-9);
}

static void outside_there_is_nothing(void **state)
{
  (void)state;
  for (int s = 0; s < 2; s++) {
    struct um_environment e = with(s ? UM_SPECTRUM_BLACK_BODY : UM_SPECTRUM_E490, 1361.0);
    assert_true(um_environment_solar_spectrum(&e, 0.0) == 0.0);
    assert_true(um_environment_solar_band(&e, 1e-6, 1e-6) == 0.0);
    assert_true(um_environment_solar_band(&e, 2e-6, 1e-6) == 0.0);
  }
  struct um_environment e = with(UM_SPECTRUM_E490, 1361.0);
  assert_true(um_environment_solar_spectrum(&e, 0.1e-6) == 0.0);
  assert_true(um_environment_solar_spectrum(&e, 2e-3) == 0.0);
}

/* Against the integrals of every point of the standard: 0.05 % is what the product promises; bands
 * that begin and end at cells are far better. */
static void regridding_keeps_the_standard(void **state)
{
  (void)state;
  static const double band[][3] = {{0.38, 0.78, 1e-5}, {0.45, 1.15, 5e-5},  {8.0, 12.0, 1e-5},
                                   {0.3, 2.5, 1e-5},   {2.5, 1000.0, 1e-5}, {0.2, 0.3, 1e-4},
                                   {3.0, 5.0, 1e-5},   {0.4, 0.7, 1e-5},    {0.383, 0.711, 5e-4},
                                   {8.3, 11.7, 5e-4},  {0.5, 0.9, 5e-4}};
  struct um_context *context = NULL;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  struct um_core_csv *csv = reference_open(context, "e490-irradiance");
  double all = reference_number(context, csv, 0, "irradiance_W_m2");
  assert_string_equal(reference_text(context, csv, 0, "kind"), "total");
  check_near("total", all, 1366.0908, 5e-5);
  struct um_environment e = with(UM_SPECTRUM_E490, all);
  size_t bands = 0, bins = 0;
  for (size_t i = 1; i < um_core_csv_rows(csv); i++) {
    const char *kind = reference_text(context, csv, i, "kind");
    double from = reference_number(context, csv, i, "from_um");
    double to = reference_number(context, csv, i, "to_um"), accepted = 1e-5;
    double truth = reference_number(context, csv, i, "irradiance_W_m2");
    if (strcmp(kind, "cell") == 0) continue; /* for tests/materials */
    if (strcmp(kind, "band") == 0) {
      assert_true(bands < 11 && from == band[bands][0] && to == band[bands][1]);
      accepted = band[bands++][2];
    } else { /* of the standard VIS band, edges of cells */
      bins++;
    }
    check_near(kind, um_environment_solar_band(&e, 1e-6 * from, 1e-6 * to) / truth, 1.0, accepted);
  }
  assert_int_equal(bands, 11);
  assert_int_equal(bins, 80);
  um_core_csv_destroy(&csv);
  um_core_context_destroy(&context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(irradiance_falls_with_the_square),
      cmocka_unit_test(black_body_bands),
      cmocka_unit_test(black_body_midpoints),
      cmocka_unit_test(standard_bands),
      cmocka_unit_test(band_is_the_integral_of_the_spectrum),
      cmocka_unit_test(outside_there_is_nothing),
      cmocka_unit_test(regridding_keeps_the_standard),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
