/* Aperture photometry: areas of circles on pixels by their closed form and by points; the share of
 * a Gaussian's light in a circle, 1 - 2^(-4 q^2); the CCD equation's check value; and over many
 * seeds of what umbra render writes to FITS, what is measured scatters by what is stated. */
#include "optics/instrument/aperture.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "optics/instrument/frame.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define SIDE 61

static float value[SIDE * SIDE];

static struct um_instrument_counts counts_of(double gain, double read_noise)
{
  return (struct um_instrument_counts){SIDE, SIDE, value, gain, read_noise, INFINITY};
}

static struct um_instrument_aperture_sum sum(const struct um_instrument_counts *c,
                                             const struct um_instrument_aperture *a)
{
  struct um_instrument_aperture_sum out;
  if (um_instrument_aperture_sum(context, c, a, &out) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return out;
}

/* Shares of all pixels add to the circle's area, whatever its place and size; one pixel's share is
 * that of points in it. */
static void test_shares(void **state)
{
  (void)state;
  const double circle[][3] = {{10.0, 10.0, 0.2},  {10.3, 9.8, 0.5},  {10.5, 10.5, 3.0},
                              {10.01, 9.6, 4.37}, {9.77, 10.2, 8.9}, {10.0, 10.0, 0.70710678}};
  for (size_t k = 0; k < sizeof circle / sizeof circle[0]; k++) {
    double x = circle[k][0], y = circle[k][1], r = circle[k][2], area = 0.0, worst = 0.0;
    for (int j = 0; j <= 20; j++)
      for (int i = 0; i <= 20; i++) {
        double share = um_instrument_pixel_share(i, j, x, y, r);
        int inside = 0;
        enum { FINE = 200 };
        for (int v = 0; v < FINE; v++)
          for (int u = 0; u < FINE; u++)
            inside += hypot(i - 0.5 + (u + 0.5) / FINE - x, j - 0.5 + (v + 0.5) / FINE - y) < r;
        worst = fmax(worst, fabs(share - (double)inside / FINE / FINE));
        area += share;
      }
    assert_close(area / (UM_PI * r * r), 1.0, 1e-12);
    assert_true(worst < 2e-3); /* an edge of up to 1.4 pixels through cells of 1/200 */
  }
}

/* docs/physics/noise.md: S 1e4, B 5, D 0.1, R 1.2, n 78.5, n_a 400: 97.0639. A flat sky of 5.1
 * electrons, the source in the middle; a circle of that area, whole counts of 1 electron left out
 * of the check value. */
static void test_ccd_equation(void **state)
{
  (void)state;
  double radius = sqrt(78.5 / UM_PI), inside = radius + 1.0;
  struct um_instrument_aperture a = {30.0, 30.0, radius, inside, inside, false};
  size_t annulus = 0;
  for (a.beyond = inside; annulus < 400; a.beyond += 1e-3) { /* the first with 400 pixels or more */
    annulus = 0;
    for (int j = 0; j < SIDE; j++)
      for (int i = 0; i < SIDE; i++)
        annulus += hypot(i - 30.0, j - 30.0) >= inside && hypot(i - 30.0, j - 30.0) <= a.beyond;
  }
  for (int i = 0; i < SIDE * SIDE; i++) value[i] = 5.1F;
  value[30 * SIDE + 30] += 1e4F;
  const struct um_instrument_counts c = counts_of(1.0, 1.2);
  struct um_instrument_aperture_sum s = sum(&c, &a);
  double pixel = 5.1 + 1.44 + 1.0 / 12.0, n = 78.5;
  double by_hand = 1e4 / sqrt(1e4 + n * (1.0 + n / (double)s.annulus) * pixel);
  print_message("%zu pixels of sky: SNR %.4f\n", s.annulus, s.snr);
  assert_true(s.annulus >= 400 && s.annulus < 420);
  assert_close(s.net, 1e4, 1e-2);
  assert_close(s.sky, 5.1, 1e-5);
  assert_close(s.snr / by_hand, 1.0, 1e-6);
  a.median = true; /* of many Gaussian deviations: pi/2 times the variance of the mean */
  assert_close(sum(&c, &a).sky_error / s.sky_error, sqrt(0.5 * UM_PI), 1e-9);
  /* 97.0639 has no whole counts: these take 0.04 */
  assert_close(s.snr, 97.0639, 0.06);
}

/* A Gaussian image of FWHM 3 pixels, drawn `seeds` times with noise. */
struct scatter {
  double mean, square, bias; /* of (net - expected)/error, and mean of net - expected [counts] */
};
/* What the circle holds of the expected light: the Gaussian's share, spread once more by the pixels
 * and by taking those that the circle cuts by their area, each a variance of 1/12 an axis:
 * 1 - exp(-r^2/(2 (s^2 + 1/6))). */
static double noiseless(const struct um_instrument_frame *f, const struct um_instrument_aperture *a,
                        double background)
{
  const struct um_instrument_readout readout = {
      .background = background, .gain = 2.0, .saturation = INFINITY, .noiseless = true};
  (void)um_instrument_frame_read(f, &readout, value);
  struct um_instrument_counts c = counts_of(2.0, 3.0);
  struct um_instrument_aperture b = *a;
  double s = 3.0 / 2.354820045, variance = s * s + 1.0 / 6.0;
  double wanted = 2e4 * (1.0 - exp(-a->radius * a->radius / (2.0 * variance)));
  b.median = false;
  c.width = f->width;
  c.height = f->height;
  double got = sum(&c, &b).net;
  assert_close(got / wanted, 1.0, 2e-3);
  return got;
}
static struct scatter scatter(double radius, bool median, double background, size_t seeds)
{
  const double rate[] = {4e4};
  const struct um_instrument_source source = {1, 1, 0.01, rate};
  const struct um_instrument_psf psf = {.kind = UM_PSF_GAUSSIAN, .fwhm = 3.0};
  const struct um_instrument_frame_options on = {.pixel = 1.0, .exposure = 1.0, .border = 20};
  struct um_instrument_frame f;
  struct scatter out = {0};
  assert_int_equal(um_instrument_frame_create(context, &source, &psf, &on, &f), UM_OK);
  assert_true(f.width <= SIDE && f.height <= SIDE);
  struct um_instrument_aperture a = {0.5 * (f.width - 1), 0.5 * (f.height - 1), radius,
                                     radius + 3.0,        radius + 9.0,         median};
  double expected = noiseless(&f, &a, background);
  for (size_t seed = 1; seed <= seeds; seed++) {
    const struct um_instrument_readout readout = {.background = background,
                                                  .read_noise = 3.0,
                                                  .gain = 2.0,
                                                  .saturation = INFINITY,
                                                  .seed = seed};
    (void)um_instrument_frame_read(&f, &readout, value);
    struct um_instrument_counts c = counts_of(2.0, 3.0);
    c.width = f.width;
    c.height = f.height;
    struct um_instrument_aperture_sum s = sum(&c, &a);
    double z = (s.net - expected) / s.error;
    out.mean += z / (double)seeds;
    out.square += z * z / (double)seeds;
    out.bias += (s.net - expected) / (double)seeds;
  }
  um_instrument_frame_clear(context, &f);
  return out;
}

/* 400 seeds: mean within four standard errors of 0, 1/20 each, mean square within four of 1,
 * sqrt(2/400) each. */
static void test_scatter(void **state)
{
  (void)state;
  const struct {
    double radius, background;
    bool median;
  } cases[] = {{3.0, 30.0, false}, {6.0, 30.0, false}, {6.0, 400.0, false},
               {6.0, 30.0, true},  {6.0, 5.0, true},   {4.5, 400.0, true}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct scatter s = scatter(cases[i].radius, cases[i].median, cases[i].background, 400);
    print_message("circle %.1f, sky %g e, %s: mean %.3f, mean square %.3f, bias %.2f counts\n",
                  cases[i].radius, cases[i].background, cases[i].median ? "median" : "mean", s.mean,
                  s.square, s.bias);
    assert_true(fabs(s.mean) < 4.0 / 20.0);
    assert_true(fabs(s.square - 1.0) < 4.0 * sqrt(2.0 / 400.0));
  }
}

/* A star in the annulus: the mean takes it for sky, the median hardly. */
static void test_star_in_annulus(void **state)
{
  (void)state;
  const struct um_instrument_counts c = counts_of(1.0, 1.0);
  struct um_instrument_aperture a = {30.0, 30.0, 5.0, 8.0, 14.0, false};
  for (int i = 0; i < SIDE * SIDE; i++) value[i] = (float)(100 + i % 3 - 1);
  for (int i = 0; i < 3; i++) value[30 * SIDE + 40 + i] = 5000.0F;
  double mean = sum(&c, &a).sky;
  a.median = true;
  double median = sum(&c, &a).sky;
  assert_true(mean > 120.0);
  assert_close(median, 100.0 + 1.0 / 6.0, 0.1);
}

static void refused(const struct um_instrument_counts *c, struct um_instrument_aperture a,
                    const char *message)
{
  struct um_instrument_aperture_sum s;
  assert_int_equal(um_instrument_aperture_sum(context, c, &a, &s), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), message);
  um_core_message_clear(context);
}

static void test_refused(void **state)
{
  (void)state;
  struct um_instrument_counts c = counts_of(1.0, 1.0);
  struct um_instrument_aperture_sum s;
  memset(value, 0, sizeof value);
  refused(&c, (struct um_instrument_aperture){10.0, 30.0, 5.0, 8.0, 14.0, false},
          "the annulus of 14 pixels about 11,31 leaves the frame of 61 x 61 pixels (1,1 is the "
          "middle of the first); accepted: all of it within");
  refused(&c, (struct um_instrument_aperture){30.0, 30.0, 5.0, 4.0, 14.0, false},
          "aperture of 5, sky from 4 to 14 pixels; accepted: above 0, and the annulus beyond the "
          "circle");
  refused(&c, (struct um_instrument_aperture){30.0, 30.0, 0.1, 0.2, 1.0, false},
          "sky annulus of 4 pixels from 0.2 to 1; accepted: 8 or more");
  value[30 * SIDE + 30] = NAN;
  refused(&c, (struct um_instrument_aperture){30.0, 30.0, 5.0, 8.0, 14.0, false},
          "pixel 31,31 in the aperture has no number; accepted: a number");
  value[30 * SIDE + 30] = 999.0F;
  c.saturation = 1000.0; /* its read noise may take it below */
  const struct um_instrument_aperture a = {30.0, 30.0, 5.0, 8.0, 14.0, false};
  assert_int_equal(um_instrument_aperture_sum(context, &c, &a, &s), UM_OK);
  assert_int_equal(s.saturated, 1);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_shares),  cmocka_unit_test(test_ccd_equation),
      cmocka_unit_test(test_scatter), cmocka_unit_test(test_star_in_annulus),
      cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
