/* Temperatures and areas from several bands: what is put in comes out; the uncertainty is that of
 * repeated draws; and two components are told from one where Catsamas et al. 2025 (arXiv
 * 2511.13030) say, from about 15 K of difference in eight bands like WISE's. */
#include "optics/instrument/grey_body.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define BANDS 8
#define BINS  10

/* Eight bands side by side from 4 to 26 um, equal in the logarithm. */
struct bands {
  double wavelength[BANDS][BINS], width[BANDS][BINS];
  struct um_instrument_bins bins[BANDS];
};

static void bands_make(struct bands *s)
{
  for (int b = 0; b < BANDS; b++) {
    double from = 4e-6 * pow(6.5, b / 8.0), to = 4e-6 * pow(6.5, (b + 1) / 8.0);
    for (int i = 0; i < BINS; i++) {
      s->width[b][i] = (to - from) / BINS;
      s->wavelength[b][i] = from + (i + 0.5) * s->width[b][i];
    }
    s->bins[b] = (struct um_instrument_bins){BINS, s->wavelength[b], s->width[b], NULL};
  }
}

static double gaussian(uint64_t stream, uint64_t index)
{
  double u = um_core_hash_uniform(um_core_hash(stream, 2 * index));
  double v = um_core_hash_uniform(um_core_hash(stream, 2 * index + 1));
  return sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * UM_PI * v);
}

/* Light of a body with the noise of photons: sigma of the brightest band 1/snr of it, of the others
 * as the square root of their photons. */
static void observe(const struct bands *s, const struct um_instrument_grey_body *body, double snr,
                    uint64_t draw, double *value, double *sigma)
{
  double photons[BANDS], most = 0.0;
  for (int b = 0; b < BANDS; b++) {
    value[b] = um_instrument_grey_body_intensity(body, &s->bins[b]);
    photons[b] = value[b] * s->wavelength[b][BINS / 2];
    most = fmax(most, photons[b]);
  }
  for (int b = 0; b < BANDS; b++) {
    sigma[b] = value[b] / snr * sqrt(most / photons[b]);
    if (draw > 0) value[b] += sigma[b] * gaussian(draw, (uint64_t)b);
  }
}

static void fit(const struct bands *s, const double *value, const double *sigma, size_t nband,
                size_t n, struct um_instrument_grey_body *out)
{
  if (um_instrument_grey_body_fit(context, s->bins, value, sigma, nband, n, out) != UM_OK)
    fail_msg("%s", um_core_message(context));
}

static void test_what_is_put_in(void **state)
{
  (void)state;
  static struct bands s;
  double value[BANDS], sigma[BANDS];
  struct um_instrument_grey_body found;
  bands_make(&s);
  const double temperature[] = {80.0, 187.3, 251.0, 300.0, 412.0, 900.0};
  for (size_t i = 0; i < sizeof temperature / sizeof temperature[0]; i++) {
    struct um_instrument_grey_body one = {.n = 1, .temperature = {temperature[i]}, .area = {7.3}};
    observe(&s, &one, 100.0, 0, value, sigma);
    fit(&s, value, sigma, BANDS, 1, &found);
    assert_close(found.temperature[0] / temperature[i], 1.0, 1e-6);
    assert_close(found.area[0] / 7.3, 1.0, 1e-5);
    assert_true(found.chi2 < 1e-3);
  }
  struct um_instrument_grey_body two = {.n = 2, .temperature = {230.0, 310.0}, .area = {20.0, 5.0}};
  observe(&s, &two, 1000.0, 0, value, sigma);
  fit(&s, value, sigma, BANDS, 2, &found);
  /* the weak prior on the share, 0.8 here, draws it by a tenth of its sigma */
  assert_close(found.temperature[0], 230.0, 0.2 * found.temperature_sigma[0]);
  assert_close(found.temperature[1], 310.0, 0.2 * found.temperature_sigma[1]);
  assert_close(found.area[0], 20.0, 0.2 * found.area_sigma[0]);
  assert_close(um_instrument_grey_body_effective(&found), 246.0, 0.05);
}

/* Over 300 draws the deviations are those that are stated. */
static void test_sigma_is_the_scatter(void **state)
{
  (void)state;
  static struct bands s;
  double value[BANDS], sigma[BANDS], square = 0.0, area = 0.0;
  struct um_instrument_grey_body one = {.n = 1, .temperature = {265.0}, .area = {3.0}}, found;
  bands_make(&s);
  enum { DRAWS = 300 };
  for (uint64_t draw = 1; draw <= DRAWS; draw++) {
    observe(&s, &one, 50.0, draw, value, sigma);
    fit(&s, value, sigma, BANDS, 1, &found);
    square += pow((found.temperature[0] - 265.0) / found.temperature_sigma[0], 2);
    area += pow((found.area[0] - 3.0) / found.area_sigma[0], 2);
  }
  print_message("mean square deviation in sigmas: T %.3f, A %.3f; sigma of T %.2f K\n",
                square / DRAWS, area / DRAWS, found.temperature_sigma[0]);
  /* the mean of n squares has a standard deviation of sqrt(2/n) = 0.082: four of them */
  assert_close(square / DRAWS, 1.0, 0.33);
  assert_close(area / DRAWS, 1.0, 0.33);
}

/* An SNR of 400 in the brightest band gives the effective temperature to a few kelvin whatever the
 * difference, and prefers two components from about 15 K of it. */
static void test_two_components(void **state)
{
  (void)state;
  static struct bands s;
  double value[BANDS], sigma[BANDS], threshold = INFINITY;
  size_t all = 0, near = 0;
  bands_make(&s);
  for (double difference = 5.0; difference <= 60.0; difference += 5.0) {
    struct um_instrument_grey_body one, both, two = {.n = 2, .area = {5.0, 5.0}};
    size_t preferred = 0;
    enum { DRAWS = 40 };
    two.temperature[0] = 280.0 - 0.5 * difference;
    two.temperature[1] = 280.0 + 0.5 * difference;
    for (uint64_t draw = 1; draw <= DRAWS; draw++) {
      observe(&s, &two, 400.0, draw, value, sigma);
      fit(&s, value, sigma, BANDS, 1, &one);
      fit(&s, value, sigma, BANDS, 2, &both);
      assert_true(both.chi2 <= one.chi2 + 0.01);
      preferred += both.bic < one.bic;
      const struct um_instrument_grey_body *best = both.bic < one.bic ? &both : &one;
      near += fabs(um_instrument_grey_body_effective(best) - 280.0) < 5.0;
      all++;
      if (difference <= 30.0) assert_true(fabs(one.temperature[0] - 280.0) < 5.0);
    }
    if (preferred > DRAWS / 2) threshold = fmin(threshold, difference);
    print_message("%4.0f K: two components preferred in %2zu of %d, one has %.1f K\n", difference,
                  preferred, DRAWS, one.temperature[0]);
    if (difference >= 40.0) assert_true(preferred == DRAWS);
  }
  print_message("preferred from %.0f K on; effective temperature within 5 K in %zu of %zu\n",
                threshold, near, all);
  assert_true(threshold >= 10.0 && threshold <= 25.0);
  assert_true(10 * near >= 9 * all);
}

/* With the errors that it was weighed by, what the errors of the bands make of temperature and area
 * is what the fit states; with others, here of one band that is twice as bad as it was weighed,
 * what repeated draws scatter by. */
static void test_error(void **state)
{
  (void)state;
  static struct bands s;
  double value[BANDS], sigma[BANDS], error[BANDS], t, a, square = 0.0, area = 0.0;
  struct um_instrument_grey_body one = {.n = 1, .temperature = {265.0}, .area = {3.0}}, found;
  enum { DRAWS = 300 };
  bands_make(&s);
  observe(&s, &one, 200.0, 0, value, sigma);
  fit(&s, value, sigma, BANDS, 1, &found);
  um_instrument_grey_body_error(&found, s.bins, sigma, sigma, BANDS, &t, &a);
  /* the slopes of the fit are differences over 1e-4 of ln T: z/2 1e-4, z = 20 at 4 um */
  assert_close(t / found.temperature_sigma[0], 1.0, 3e-3);
  assert_close(a / found.area_sigma[0], 1.0, 3e-3);
  for (int b = 0; b < BANDS; b++) error[b] = (b == 3 ? 3.0 : 0.2) * sigma[b];
  um_instrument_grey_body_error(&found, s.bins, sigma, error, BANDS, &t, &a);
  for (uint64_t draw = 1; draw <= DRAWS; draw++) {
    double drawn[BANDS];
    for (int b = 0; b < BANDS; b++) drawn[b] = value[b] + error[b] * gaussian(draw, (uint64_t)b);
    fit(&s, drawn, sigma, BANDS, 1, &found);
    square += pow((found.temperature[0] - 265.0) / t, 2) / DRAWS;
    area += pow((found.area[0] - 3.0) / a, 2) / DRAWS;
  }
  print_message("mean square deviation in stated errors: T %.3f, A %.3f\n", square, area);
  assert_close(square, 1.0, 0.33); /* four standard deviations of the mean of 300 squares */
  assert_close(area, 1.0, 0.33);
}

/* Bins that touch and let through the same are one; a gap or another transmission parts them. */
static void test_bins(void **state)
{
  (void)state;
  const double wavelength[] = {8.5e-6, 9.5e-6, 11.5e-6, 12.5e-6},
               width[] = {1e-6, 1e-6, 1e-6, 1e-6};
  const double passed[] = {1.0, 1.0, 1.0, 0.25};
  const struct um_instrument_bins band = {4, wavelength, width, passed};
  const struct um_instrument_grey_body one = {.n = 1, .temperature = {300.0}, .area = {2.0}};
  double by_hand = um_core_planck_band(8e-6, 10e-6, 300.0) +
                   um_core_planck_band(11e-6, 12e-6, 300.0) +
                   0.25 * um_core_planck_band(12e-6, 13e-6, 300.0);
  assert_close(um_instrument_grey_body_intensity(&one, &band) / (2.0 * by_hand), 1.0, 1e-12);
}

/* A mirror of something hotter than the fit lets two be apart, exp(1.5), where the scan alone would
 * begin: what comes is the bound, and it is better than one. */
static void test_far_apart(void **state)
{
  (void)state;
  static struct bands s;
  double value[BANDS], sigma[BANDS];
  struct um_instrument_grey_body one, two,
      light = {.n = 2, .temperature = {200.0, 1400.0}, .area = {10.0, 0.1}};
  bands_make(&s);
  observe(&s, &light, 100.0, 0, value, sigma);
  fit(&s, value, sigma, BANDS, 1, &one);
  fit(&s, value, sigma, BANDS, 2, &two);
  print_message("one %.1f K, chi2 %.3g; two %.1f and %.1f K, %.3g\n", one.temperature[0], one.chi2,
                two.temperature[0], two.temperature[1], two.chi2);
  assert_close(two.temperature[1] / two.temperature[0], exp(1.5), 1e-3);
  assert_true(two.chi2 < one.chi2);
}

static void test_refused(void **state)
{
  (void)state;
  static struct bands s;
  struct um_instrument_grey_body found;
  double value[BANDS], sigma[BANDS];
  struct um_instrument_grey_body one = {.n = 1, .temperature = {265.0}, .area = {3.0}};
  bands_make(&s);
  observe(&s, &one, 50.0, 0, value, sigma);
  assert_int_equal(um_instrument_grey_body_fit(context, s.bins, value, sigma, 2, 1, &found),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "2 thermal bands; accepted: 3 or more for a temperature");
  um_core_message_clear(context);
  assert_int_equal(um_instrument_grey_body_fit(context, s.bins, value, sigma, 4, 2, &found),
                   UM_ERR_INPUT);
  um_core_message_clear(context);
  sigma[1] = 0.0;
  assert_int_equal(um_instrument_grey_body_fit(context, s.bins, value, sigma, BANDS, 1, &found),
                   UM_ERR_INPUT);
  um_core_message_clear(context);
  for (int b = 0; b < BANDS; b++) {
    sigma[b] = 1.0;
    value[b] = -1.0;
  }
  assert_int_equal(um_instrument_grey_body_fit(context, s.bins, value, sigma, BANDS, 1, &found),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "no light in any band; accepted: some in one");
  um_core_message_clear(context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_what_is_put_in), cmocka_unit_test(test_sigma_is_the_scatter),
      cmocka_unit_test(test_two_components), cmocka_unit_test(test_error),
      cmocka_unit_test(test_bins),           cmocka_unit_test(test_far_apart),
      cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
