/* Frames of a detector: energy, place, width, trail, noise. */
#include "instrument/frame.h"

#include <math.h>
#include <stdlib.h>

#include "core/constants.h"
#include "tests/support/cmocka_all.h"

#define SIDE 40 /* pixels of the source */

static struct um_context *context;
static double rate[SIDE * SIDE];

static int enter(void **state)
{
  (void)state;
  for (int i = 0; i < SIDE * SIDE; i++) rate[i] = 0.0;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int leave(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return 0;
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

/* A point's light within a circle of q FWHM is what D.7 says, 1 - 2^(-4 q^2); 20 pixels a FWHM.
 * Airy's wings that the frame does not hold are outside, and nothing else. */
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

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_energy, enter, leave),
      cmocka_unit_test_setup_teardown(test_point, enter, leave),
      cmocka_unit_test_setup_teardown(test_counts, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
