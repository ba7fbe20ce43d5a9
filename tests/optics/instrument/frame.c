/* Frames of a detector: energy, place, width, trail, noise. */
#include "optics/instrument/frame.h"

#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define SIDE 40 /* pixels of the source */

static double rate[SIDE * SIDE];

static int enter(void **state)
{
  for (int i = 0; i < SIDE * SIDE; i++) rate[i] = 0.0;
  return context_set_up(state);
}

/* Sum, middle [arcsec from the frame's] and variance along the axes [arcsec^2]. */
struct moments {
  double sum, x, y, xx, yy, xy;
};

static struct moments measure(const struct um_instrument_frame *f)
{
  struct moments m = {0};
  for (int pass = 0; pass < 2; pass++)
    for (int j = 0; j < f->height; j++)
      for (int i = 0; i < f->width; i++) {
        double e = f->electrons[j * f->width + i];
        double x = (i + 0.5 - 0.5 * f->width) * f->pixel;
        double y = (0.5 * f->height - j - 0.5) * f->pixel;
        if (pass == 0) {
          m.sum += e;
          m.x += e * x;
          m.y += e * y;
        } else {
          m.xx += e / m.sum * (x - m.x / m.sum) * (x - m.x / m.sum);
          m.yy += e / m.sum * (y - m.y / m.sum) * (y - m.y / m.sum);
          m.xy += e / m.sum * (x - m.x / m.sum) * (y - m.y / m.sum);
        }
      }
  m.x /= m.sum;
  m.y /= m.sum;
  return m;
}

/* A bar off the middle, smeared by 12 arcsec at 30 degrees, exposed for 2 s: all of its electrons
 * are there (1e-6), their middle is the bar's, and variances add up: of the bar's pixels, the
 * trail's L^2/12 and the Gaussian's FWHM^2/(8 ln 2); what splitting between cells and summing in
 * pixels adds is known: cell^2/6 at most and (pixel^2 - cell^2)/12. */
static void test_energy(void **state)
{
  (void)state;
  const struct um_instrument_psf psf[] = {{.kind = UM_PSF_GAUSSIAN, .fwhm = 3.0},
                                          {.kind = UM_PSF_MOFFAT, .fwhm = 3.0, .beta = 4.765}};
  const struct um_instrument_source source = {SIDE, SIDE, 0.2, rate};
  const struct um_instrument_frame_options options = {
      .pixel = 1.0, .exposure = 2.0, .trail = 12.0, .trail_angle = 30.0 * UM_DEG, .border = 1};
  double total = 0.0, var_x = 0.0;
  for (int i = 25; i < 35; i++) rate[10 * SIDE + i] = 100.0 + i;
  double middle = 0.0, up = (0.5 * SIDE - 10.5) * 0.2;
  for (int i = 0; i < SIDE; i++) total += rate[10 * SIDE + i];
  for (int i = 0; i < SIDE; i++)
    middle += rate[10 * SIDE + i] / total * (i + 0.5 - 0.5 * SIDE) * 0.2;
  for (int i = 0; i < SIDE; i++)
    var_x += rate[10 * SIDE + i] / total * pow((i + 0.5 - 0.5 * SIDE) * 0.2 - middle, 2.0);
  for (int k = 0; k < 2; k++) {
    struct um_instrument_frame frame;
    assert_int_equal(um_instrument_frame_create(context, &source, &psf[k], &options, &frame),
                     UM_OK);
    struct moments m = measure(&frame);
    print_message("%d x %d: %.8f of the light, middle %.6f %.6f\n", frame.width, frame.height,
                  m.sum / (2.0 * total), m.x - middle, m.y - up);
    assert_true(fabs(frame.source - 2.0 * total) <= 1e-9 * total);
    assert_true(fabs(m.sum / (2.0 * total) - 1.0) <= 1e-6);
    assert_true(fabs(m.sum + frame.outside - frame.source) <= 1e-9 * total);
    assert_true(fabs(m.x - middle) <= 1e-6 && fabs(m.y - up) <= 1e-6);
    double spread = 9.0 / (8.0 * log(2.0)) + (1.0 - 1.0 / 9.0) / 12.0 + 1.0 / 9.0 / 12.0;
    double along = 144.0 / 12.0 * 0.75, across = 144.0 / 12.0 * 0.25;
    if (k == 0) {
      assert_true(fabs(m.xx - (var_x + along + spread)) <= 1.0 / 9.0 / 6.0 + 1e-3);
      assert_true(fabs(m.yy - (across + spread)) <= 1.0 / 9.0 / 6.0 + 1e-3);
      assert_true(fabs(m.xy - 12.0 * sqrt(0.1875)) <= 1e-3);
    }
    um_instrument_frame_clear(context, &frame);
  }
}

/* A point's light within a circle of q FWHM is what docs/physics/noise.md says, 1 - 2^(-4 q^2); 20
 * pixels a FWHM. Airy's wings that the frame does not hold are outside, and nothing else. */
static void test_point(void **state)
{
  (void)state;
  const struct um_instrument_psf gauss = {.kind = UM_PSF_GAUSSIAN, .fwhm = 4.0};
  const struct um_instrument_psf airy = {.kind = UM_PSF_AIRY, .diffraction = 0.5};
  double one = 1000.0;
  const struct um_instrument_source source = {1, 1, 0.01, &one};
  struct um_instrument_frame_options options = {.pixel = 0.2, .exposure = 1.0};
  struct um_instrument_frame frame;
  assert_int_equal(um_instrument_frame_create(context, &source, &gauss, &options, &frame), UM_OK);
  for (double q = 0.5; q < 1.6; q += 0.5) {
    double sum = 0.0;
    for (int j = 0; j < frame.height; j++)
      for (int i = 0; i < frame.width; i++)
        if (hypot(i + 0.5 - 0.5 * frame.width, j + 0.5 - 0.5 * frame.height) * 0.2 < 4.0 * q)
          sum += frame.electrons[j * frame.width + i] / one;
    print_message("within %.1f FWHM: %.5f\n", q, sum);
    assert_true(fabs(sum - (1.0 - exp2(-4.0 * q * q))) <= 0.01);
  }
  um_instrument_frame_clear(context, &frame);
  assert_int_equal(um_instrument_frame_create(context, &source, &airy, &options, &frame), UM_OK);
  double edge = 0.5 * frame.width * 0.2, lost = frame.outside / one;
  print_message("Airy: %.5f outside %.1f arcsec\n", lost, edge);
  assert_true(lost > 1.0 - um_instrument_psf_encircled(&airy, 1.5 * edge));
  assert_true(lost < 1.0 - um_instrument_psf_encircled(&airy, 0.9 * edge));
  um_instrument_frame_clear(context, &frame);
  options.pixel = 1e-3;
  assert_int_equal(um_instrument_frame_create(context, &source, &gauss, &options, &frame), UM_OK);
  um_instrument_frame_clear(context, &frame);
  const struct um_instrument_source wide = {SIDE, SIDE, 1.0, rate};
  assert_int_equal(um_instrument_frame_create(context, &wide, &gauss, &options, &frame),
                   UM_ERR_INPUT);
  assert_null(frame.electrons);
}

/* Counts: mean and variance of 40000 pixels are Poisson's and the read noise's, e/g and
 * (e + r^2)/g^2 + 1/12, within four standard errors, below and above the mean where the way of
 * drawing changes; the same seed gives the same counts; a full pixel holds no more. */
static void test_counts(void **state)
{
  (void)state;
  enum { N = 200 };
  static double electrons[N * N];
  static float counts[N * N], again[N * N];
  const struct um_instrument_frame frame = {
      .width = N, .height = N, .pixel = 1.0, .electrons = electrons};
  const double level[] = {3.0, 25.0, 40.0, 900.0};
  for (int k = 0; k < 4; k++) {
    struct um_instrument_readout readout = {
        .background = 20.0, .read_noise = 1.4, .gain = 0.45, .saturation = INFINITY, .seed = 7};
    double mean = 0.0, variance = 0.0, e = level[k] + 20.0;
    for (int i = 0; i < N * N; i++) electrons[i] = level[k];
    assert_int_equal(um_instrument_frame_read(&frame, &readout, counts), 0);
    um_instrument_frame_read(&frame, &readout, again);
    assert_memory_equal(counts, again, sizeof counts);
    for (int i = 0; i < N * N; i++) mean += (double)counts[i] / (N * N);
    for (int i = 0; i < N * N; i++) variance += pow((double)counts[i] - mean, 2.0) / (N * N - 1);
    double expected = (e + 1.4 * 1.4) / (0.45 * 0.45) + 1.0 / 12.0;
    print_message("%g e: mean %.3f (%.3f), variance %.2f (%.2f)\n", e, mean, e / 0.45, variance,
                  expected);
    assert_true(fabs(mean - e / 0.45) <= 4.0 * sqrt(expected) / N);
    assert_true(fabs(variance / expected - 1.0) <= 4.0 * sqrt(2.2) / N);
    readout.saturation = 10.0;
    readout.read_noise = 0.0;
    assert_true(um_instrument_frame_read(&frame, &readout, counts) > N * N / 2);
    for (int i = 0; i < N * N; i++) assert_true(counts[i] <= 22.0F); /* 10/0.45 */
    readout.noiseless = true;
    readout.saturation = INFINITY;
    um_instrument_frame_read(&frame, &readout, counts);
    assert_true(fabs((double)counts[0] - e / 0.45) <= 1e-6 * e / 0.45);
  }
}

enum { PIXELS = 40000 };

/* Mean, variance, skewness of counts, and the correlation of neighbours. */
struct scatter {
  double mean, variance, skewness, neighbours;
};

static struct scatter scatter_of(const float *counts)
{
  struct scatter s = {0};
  for (int i = 0; i < PIXELS; i++) s.mean += (double)counts[i] / PIXELS;
  for (int i = 0; i < PIXELS; i++) {
    double d = (double)counts[i] - s.mean;
    s.variance += d * d / PIXELS;
    s.skewness += d * d * d / PIXELS;
    if (i > 0) s.neighbours += d * ((double)counts[i - 1] - s.mean) / PIXELS;
  }
  s.skewness /= pow(s.variance, 1.5);
  s.neighbours /= s.variance;
  return s;
}

/* Dark pixels have the read noise alone, r^2/g^2 + 1/12 about 0; full ones have it about what they
 * hold; each pixel and each seed its own. Without it, counts have Poisson's skewness, e^(-1/2).
 * Four standard errors: 1, sqrt(2), sqrt(6) and 1 over the root of the number of pixels. */
static void test_read_noise(void **state)
{
  (void)state;
  static double electrons[PIXELS];
  static float counts[PIXELS], other[PIXELS];
  const struct um_instrument_frame frame = {
      .width = 200, .height = 200, .pixel = 1.0, .electrons = electrons};
  const double g = 0.45, r = 12.0, variance = r * r / (g * g) + 1.0 / 12.0, one = 4.0 / 200.0;
  struct um_instrument_readout readout = {
      .read_noise = r, .gain = g, .saturation = INFINITY, .seed = 7};
  for (int full = 0; full < 2; full++) {
    for (int i = 0; i < PIXELS; i++) electrons[i] = full ? 1000.0 : 0.0;
    readout.saturation = full ? 500.0 : INFINITY;
    assert_int_equal(um_instrument_frame_read(&frame, &readout, counts), full ? PIXELS : 0);
    struct scatter s = scatter_of(counts);
    double level = full ? 500.0 / g : 0.0, sum = 0.0;
    print_message("%s: mean %.3f (%.3f), variance %.2f (%.2f)\n", full ? "full" : "dark", s.mean,
                  level, s.variance, variance);
    assert_true(fabs(s.mean - level) <= one * sqrt(variance));
    assert_true(fabs(s.variance / variance - 1.0) <= one * sqrt(2.0));
    assert_true(fabs(s.skewness) <= one * sqrt(6.0));
    assert_true(fabs(s.neighbours) <= one);
    readout.seed++;
    um_instrument_frame_read(&frame, &readout, other);
    for (int i = 0; i < PIXELS; i++)
      sum += ((double)counts[i] - s.mean) * ((double)other[i] - s.mean) / PIXELS;
    assert_true(fabs(sum / s.variance) <= one);
  }
  readout.read_noise = 0.0;
  readout.saturation = INFINITY;
  readout.gain = 1.0;
  for (int k = 0; k < 2; k++) { /* drawn one by one, and not */
    double e = k == 0 ? 25.0 : 60.0;
    for (int i = 0; i < PIXELS; i++) electrons[i] = e;
    um_instrument_frame_read(&frame, &readout, counts);
    struct scatter s = scatter_of(counts);
    print_message("%.0f e: variance %.3f, skewness %.4f (%.4f)\n", e, s.variance, s.skewness,
                  1.0 / sqrt(e));
    assert_true(fabs(s.variance / e - 1.0) <= one * sqrt(2.0 + 1.0 / e));
    assert_true(fabs(s.skewness - 1.0 / sqrt(e)) <= 1.1 * one * sqrt(6.0));
  }
}

/* Stars beside a dark source: all their electrons, at their places [arcsec right and up]. */
static void test_stars(void **state)
{
  (void)state;
  const struct um_instrument_psf psf = {.kind = UM_PSF_GAUSSIAN, .fwhm = 2.5};
  const struct um_instrument_source source = {SIDE, SIDE, 0.2, rate};
  const struct um_instrument_frame_star star[2] = {{.x = 7.3, .y = 2.1, .rate = 300.0},
                                                   {.x = -1.2, .y = -5.9, .rate = 100.0}};
  const struct um_instrument_frame_options options = {
      .pixel = 1.0, .exposure = 2.0, .trail = 6.0, .nstar = 2, .star = star};
  struct um_instrument_frame frame;
  assert_int_equal(um_instrument_frame_create(context, &source, &psf, &options, &frame), UM_OK);
  struct moments m = measure(&frame);
  assert_true(fabs(frame.stars - 800.0) <= 1e-9 && frame.source == 0.0);
  assert_true(fabs(m.sum - 800.0) <= 1e-6 * 800.0);
  assert_true(fabs(m.x - (0.75 * 7.3 - 0.25 * 1.2)) <= 1e-5);
  assert_true(fabs(m.y - (0.75 * 2.1 - 0.25 * 5.9)) <= 1e-5);
  um_instrument_frame_clear(context, &frame);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_energy, enter, context_tear_down),
      cmocka_unit_test_setup_teardown(test_point, enter, context_tear_down),
      cmocka_unit_test_setup_teardown(test_counts, enter, context_tear_down),
      cmocka_unit_test_setup_teardown(test_read_noise, enter, context_tear_down),
      cmocka_unit_test_setup_teardown(test_stars, enter, context_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
