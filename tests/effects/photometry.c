/* Effects on what is measured: they change irradiance and magnitude and nothing else. A box 620 km
 * above the Earth is seen from a station below it, and from one on the other side. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/airmass.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

/* At noon of the equinox GCRS +x stands 2 deg east of Greenwich: (1, 1, 0) is above 47 deg east. */
#define SCENARIO(station)                                                                          \
  "schema: 1\n"                                                                                    \
  "name: photometry\n"                                                                             \
  "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:04:00Z, step_s: 120}\n"         \
  "orbit: {fixed: {position_gcrs_km: [4950, 4950, 0]}}\n"                                          \
  "attitude: [{fixed: {q_gcrs: [1, 0, 0, 0]}}]\n"                                                  \
  "observer: " station "\n"                                                                        \
  "parts:\n"                                                                                       \
  "  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_panel, lumped: true,\n"                 \
  "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"                                              \
  "thermal: {start: isothermal, orbits_before: 0}\n"                                               \
  "bands:\n"                                                                                       \
  "  vis: {from_um: 0.38, to_um: 0.78, bins: 2}\n"                                                 \
  "  lwir: {from_um: 8, to_um: 12, bins: 2}\n"

static const char below[] =
    SCENARIO("{station: {latitude_deg: 4, longitude_deg: 47, height_m: 0}}");
static const char behind[] =
    SCENARIO("{station: {latitude_deg: 4, longitude_deg: -133, height_m: 0}}");
static const char nowhere[] = SCENARIO("{direction: {unit_gcrs: [-1, -0.8, 0.3], range_km: 500}}");

/* Band irradiance [W/m^2] of magnitude 0, flat in wavelength, of a band in two bins: with E = 1 in
 * photons, int lambda d lambda = width * middle, against 3631 Jy c int d lambda / lambda. */
static double flat_zero(double from_um, double to_um)
{
  return 3631e-26 * 299792458.0 * log(to_um / from_um) / (0.5 * (from_um + to_um) * 1e-6);
}

/* Irradiance becomes factor(X) E + offset in the bands of a mask, the irradiance that the magnitude
 * stands for factor(0) E + offset, and the radiant intensity that is concluded from it R^2 times
 * that; all else is the same to the bit. */
static void expect(const char *with, unsigned mask, double k, double factor, double offset)
{
  struct case_run a = case_with(below, NULL), b = case_with(below, with);
  assert_true(case_same_temperatures(&a, &b));
  assert_true(case_same_intensities(&a, &b));
  for (size_t t = 0; t < a.result->nobs; t++) {
    double airmass = um_environment_airmass_toward(a.tables->look[t].elevation);
    assert_true(airmass > 1.0 && airmass < 3.0);
    for (size_t band = 0; band < 2; band++) {
      double before = a.result->irradiance[2 * t + band],
             after = b.result->irradiance[2 * t + band];
      double m = a.result->magnitude_ab[2 * t + band], m1 = b.result->magnitude_ab[2 * t + band];
      double intensity = um_model_result_intensity(a.result, t, band, -1);
      double concluded = b.result->measured_intensity[2 * t + band];
      double square = a.tables->sample[t].range * a.tables->sample[t].range; /* [m^2] */
      assert_true(a.result->measured_intensity[2 * t + band] == intensity);
      assert_true(before > 0.0);
      if ((mask >> band & 1) == 0) {
        assert_true(after == before && m1 == m && concluded == intensity);
        continue;
      }
      case_near(with, after, factor * pow(10.0, -0.4 * k * airmass) * before + offset, 1e-14);
      if (factor == 1.0 && offset == 0.0) { /* the atmosphere */
        assert_true(m1 == m && concluded == intensity);
        continue;
      }
      double zero = band == 0 ? flat_zero(0.38, 0.78) : flat_zero(8.0, 12.0);
      /* rounding of log10 and of magnitudes near 10 */
      case_near(with, pow(10.0, -0.4 * m1), factor * pow(10.0, -0.4 * m) + offset / zero, 1e-13);
      case_near(with, concluded, factor * intensity + offset * square, 1e-14);
    }
  }
  case_release(&a);
  case_release(&b);
}

static void extinction_grows_with_airmass(void **state)
{
  (void)state;
  expect("extinction,k_mag=0.25", 3, 0.25, 1.0, 0.0);
  expect("extinction:vis,k_mag=0.25", 1, 0.25, 1.0, 0.0);
  expect("extinction:lwir,k_mag=-0.1", 2, -0.1, 1.0, 0.0);
}

static void zero_point_is_a_factor(void **state)
{
  (void)state;
  expect("zero_point,factor=0.7", 3, 0.0, 0.7, 0.0);
  expect("zero_point:lwir,factor=1.2", 2, 0.0, 1.2, 0.0);
}

static void background_is_added(void **state)
{
  (void)state;
  expect("background,irradiance_W_m2=3e-11", 3, 0.0, 1.0, 3e-11);
  expect("background:vis,irradiance_W_m2=-2e-12", 1, 0.0, 1.0, -2e-12);
}

/* Values of a law that a formula of elsewhere gives, at every instant, band 0: `law` of the plain
 * irradiance and of the irradiance that the magnitude stands for; the other band stays. */
static void expect_law(const char *with, double (*law)(double e, double elevation))
{
  struct case_run a = case_with(below, NULL), b = case_with(below, with);
  double zero = flat_zero(0.38, 0.78);
  assert_true(case_same_temperatures(&a, &b));
  assert_true(case_same_intensities(&a, &b));
  for (size_t t = 0; t < a.result->nobs; t++) {
    double h = a.tables->look[t].elevation, e = a.result->irradiance[2 * t];
    double m = zero * pow(10.0, -0.4 * a.result->magnitude_ab[2 * t]);
    case_near(with, b.result->irradiance[2 * t], law(e, h), 1e-13);
    case_near(with, zero * pow(10.0, -0.4 * b.result->magnitude_ab[2 * t]), law(m, h), 1e-12);
    assert_true(b.result->irradiance[2 * t + 1] == a.result->irradiance[2 * t + 1]);
  }
  case_release(&a);
  case_release(&b);
}

/* The share of a Moffat image of exponent 3 outside its circle, integrated over rings; the image's
 * width so that 0.05 is lost at the zenith, and in proportion to X^0.6 below it. */
static double outside_of_moffat(double width)
{
  double sum = 0.0, step = 1e-4; /* of u = a^2/(a^2 + r^2), r from 1 outward */
  double from = width * width / (1.0 + width * width);
  for (double u = 0.5 * step * from; u < from; u += step * from) sum += 2.0 * u * step * from;
  return sum; /* int 2 (beta - 1)/a^2 r (1 + r^2/a^2)^-3 dr = int 2 u du */
}

static double less_outside(double e, double elevation)
{
  double u = sqrt(0.05), width = sqrt(u / (1.0 - u));
  return e * (1.0 - outside_of_moffat(width * pow(um_environment_airmass_toward(elevation), 0.6)));
}

static void circle_loses_more_toward_the_horizon(void **state)
{
  (void)state;
  case_near("zenith", outside_of_moffat(sqrt(sqrt(0.05) / (1.0 - sqrt(0.05)))), 0.05, 1e-9);
  expect_law("aperture_loss:vis,share=0.05", less_outside);
}

/* The length of sight through a thin layer 90 km up, by the law of sines in the triangle of the
 * geocentre, the station and the layer. */
static double with_airglow(double e, double elevation)
{
  double zenith = 0.5 * UM_PI - elevation;
  double inner = asin(sin(zenith) * UM_EARTH_RADIUS / (UM_EARTH_RADIUS + 90e3));
  return e + 2e-10 / cos(inner);
}

static double with_path(double e, double elevation)
{
  double x = um_environment_airmass_toward(elevation);
  return e + 3e-10 * (1.0 - exp(-0.5 * x)) / (1.0 - exp(-0.5));
}

static double bent(double e, double elevation)
{
  (void)elevation; /* 3631 Jy is magnitude 0: of magnitude 5, a hundredth, a tenth is lost */
  return e / (1.0 + 0.1 * e / (0.01 * flat_zero(0.38, 0.78)));
}

static double bent_up(double e, double elevation)
{
  (void)elevation;
  return e * (1.0 + 0.002 * e / (0.01 * flat_zero(0.38, 0.78)));
}

static void skies_and_detectors_follow_their_laws(void **state)
{
  (void)state;
  expect_law("sky_background:vis,irradiance_W_m2=2e-10", with_airglow);
  expect_law("path_radiance:vis,irradiance_W_m2=3e-10,depth=0.5", with_path);
  expect_law("nonlinearity:vis,share=0.1", bent);
  expect_law("nonlinearity:vis,share=-0.002", bent_up);
}

/* A satellite in the dark sends 1e-29 of what is left in the visible: the magnitude is that of the
 * background, and of a negative one there is none. */
static void background_has_a_magnitude_in_the_dark(void **state)
{
  (void)state;
  static const char *const set[] = {"orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}", NULL};
  static const char *const without[] = {"earthshine", NULL};
  const double irradiance = 2e-13;
  const char *const more[] = {"background:vis,irradiance_W_m2=2e-13", NULL};
  const char *const less[] = {"background:vis,irradiance_W_m2=-2e-13", NULL};
  struct case_run a = case_compute(nowhere, more, without, set);
  struct case_run b = case_compute(nowhere, less, without, set);
  double expected = -2.5 * log10(irradiance / flat_zero(0.38, 0.78)); /* 12.07 */
  for (size_t t = 0; t < a.result->nobs; t++) {
    case_near("dark", a.result->magnitude_ab[2 * t], expected, 1e-13);
    assert_true(isnan(b.result->magnitude_ab[2 * t]));
  }
  case_release(&a);
  case_release(&b);
}

/* Below the horizon, and behind the Earth for who looks from elsewhere, there is no measurement,
 * whatever is added to it; the satellite's own intensity is what it is. */
static void nothing_is_seen_below_the_horizon(void **state)
{
  (void)state;
  static const char *const with[] = {"extinction,k_mag=0.25", "background,irradiance_W_m2=1e-11",
                                     "zero_point,factor=0.5", NULL};
  /* from 7000 km up a ray to the side passes the Earth, one straight through it does not; a camera
   * 500 km below the satellite is on this side of it */
  static const struct {
    const char *observer;
    bool hidden;
  } places[] = {{"observer={direction: {unit_gcrs: [-1, -1, 0], range_km: 14000}}", true},
                {"observer={direction: {unit_gcrs: [-1, -1, 0], range_km: 500}}", false},
                {"observer={direction: {unit_gcrs: [-1, -0.8, 3], range_km: 14000}}", false},
                {"observer={direction: {unit_gcrs: [1, 1, 0], range_km: 14000}}", false}};
  struct case_run a = case_compute(behind, with, NULL, NULL);
  for (size_t i = 0; i < a.result->nobs * a.result->nband; i++) {
    assert_true(isnan(a.result->irradiance[i]) && isnan(a.result->magnitude_ab[i]));
    assert_true(um_model_result_intensity(a.result, i / 2, i % 2, -1) > 0.0);
  }
  case_release(&a);
  for (size_t p = 0; p < sizeof places / sizeof places[0]; p++) {
    const char *const set[] = {places[p].observer, NULL};
    a = case_compute(behind, with, NULL, set);
    for (size_t i = 0; i < a.result->nobs * a.result->nband; i++) {
      assert_true(a.tables->hidden[i / 2] == places[p].hidden);
      assert_true(isnan(a.result->irradiance[i]) == places[p].hidden);
      assert_true(isnan(a.result->magnitude_ab[i]) == places[p].hidden);
      assert_true(um_model_result_intensity(a.result, i / 2, i % 2, -1) > 0.0);
    }
    case_release(&a);
  }
}

/* Without a station there is no air. */
static void extinction_needs_a_station(void **state)
{
  (void)state;
  struct case_run a = case_with(nowhere, NULL), b = case_with(nowhere, "extinction,k_mag=0.25");
  assert_true(case_same(&a, &b));
  assert_true(a.result->irradiance[0] > 0.0);
  case_release(&a);
  case_release(&b);
}

static void null_values_change_nothing(void **state)
{
  (void)state;
  static const char *const with[] = {"extinction,k_mag=0",
                                     "background,irradiance_W_m2=0",
                                     "zero_point,factor=1",
                                     "aperture_loss,share=0",
                                     "nonlinearity,share=0",
                                     "sky_background,irradiance_W_m2=0",
                                     "path_radiance,irradiance_W_m2=0",
                                     NULL};
  struct case_run a = case_with(below, NULL), b = case_compute(below, with, NULL, NULL);
  assert_true(case_same(&a, &b));
  case_release(&a);
  case_release(&b);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(extinction_grows_with_airmass),
      cmocka_unit_test(zero_point_is_a_factor),
      cmocka_unit_test(background_is_added),
      cmocka_unit_test(circle_loses_more_toward_the_horizon),
      cmocka_unit_test(skies_and_detectors_follow_their_laws),
      cmocka_unit_test(background_has_a_magnitude_in_the_dark),
      cmocka_unit_test(nothing_is_seen_below_the_horizon),
      cmocka_unit_test(extinction_needs_a_station),
      cmocka_unit_test(null_values_change_nothing),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
