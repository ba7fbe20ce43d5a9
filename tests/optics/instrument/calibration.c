/* Factor and extinction from stars: what is put in comes out; errors are those of repeated draws,
 * their correlation with them; too little is refused. */
#include "optics/instrument/calibration.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define STARS 8

static double gaussian(uint64_t stream, uint64_t index)
{
  double u = um_core_hash_uniform(um_core_hash(stream, 2 * index));
  double v = um_core_hash_uniform(um_core_hash(stream, 2 * index + 1));
  return sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * UM_PI * v);
}

/* Stars of 5 to 9 mag from the zenith to 20 deg, read at a factor of 0.5 and 0.23 mag per airmass;
 * noise of their own photons and 0.2 %. */
static void make(struct um_instrument_star *star, uint64_t draw)
{
  for (int i = 0; i < STARS; i++) {
    double x = 1.0 + 1.9 * i / (STARS - 1.0), m = 5.0 + (i * 3) % 5;
    double predicted = 6.7e6 * pow(10.0, -0.4 * (m - 6.0));
    double measured = predicted * 0.5 * pow(10.0, -0.4 * 0.23 * x);
    double sigma = hypot(sqrt(measured), 0.002 * measured);
    star[i] = (struct um_instrument_star){
        x, measured + (draw > 0 ? sigma * gaussian(draw, (uint64_t)i) : 0.0), sigma, predicted};
  }
}

static struct um_instrument_calibration calibrate(const struct um_instrument_star *star, size_t n,
                                                  double extinction)
{
  struct um_instrument_calibration c;
  size_t at;
  if (um_instrument_calibrate(context, star, n, extinction, &c, &at) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return c;
}

static void test_what_is_put_in(void **state)
{
  (void)state;
  struct um_instrument_star star[STARS];
  double relative;
  make(star, 0);
  struct um_instrument_calibration c = calibrate(star, STARS, NAN);
  assert_close(c.kappa, 0.5, 1e-12);
  assert_close(c.extinction, 0.23, 1e-12);
  assert_true(c.chi2 < 1e-18 && c.dof == STARS - 2);
  assert_close(um_instrument_calibration_factor(&c, 1.7, &relative),
               0.5 * pow(10.0, -0.4 * 0.23 * 1.7), 1e-12);
  c = calibrate(star, 1, 0.23); /* one star will do */
  assert_close(c.kappa, 0.5, 1e-12);
  assert_true(c.extinction_sigma == 0.0 && c.dof == 0);
  /* two stars, by hand */
  c = calibrate(star, 2, NAN);
  assert_close(c.kappa, 0.5, 1e-12);
  double s = 2.5 / log(10.0), dx = star[1].airmass - star[0].airmass;
  double s0 = s * star[0].sigma / star[0].measured, s1 = s * star[1].sigma / star[1].measured;
  assert_close(c.extinction_sigma / (hypot(s0, s1) / dx), 1.0, 1e-12);
}

/* Two stars of which one weighs 1e20 times the other: by hand as before. */
static void test_uneven(void **state)
{
  (void)state;
  struct um_instrument_star star[STARS];
  make(star, 0);
  star[0].sigma = 1e-10 * star[0].measured;
  star[1].sigma = star[1].measured;
  struct um_instrument_calibration c = calibrate(star, 2, NAN);
  double s = 2.5 / log(10.0), dx = star[1].airmass - star[0].airmass;
  assert_close(c.kappa, 0.5, 1e-12);
  assert_close(c.extinction, 0.23, 1e-12);
  assert_close(c.extinction_sigma / (s / dx), 1.0, 1e-12);
  assert_close(c.kappa_sigma / (c.kappa * log(10.0) / 2.5 * c.extinction_sigma * star[0].airmass),
               1.0, 1e-12);
  assert_close(c.correlation, -1.0, 1e-12);
}

/* 400 draws; four standard errors of a mean square, 4 sqrt(2/400) = 0.28. */
static void test_scatter(void **state)
{
  (void)state;
  enum { DRAWS = 400 };
  struct um_instrument_star star[STARS];
  double kappa = 0.0, k = 0.0, chi2 = 0.0, factor[3] = {0.0}, relative;
  for (uint64_t draw = 1; draw <= DRAWS; draw++) {
    make(star, draw);
    struct um_instrument_calibration c = calibrate(star, STARS, NAN);
    kappa += pow((c.kappa - 0.5) / c.kappa_sigma, 2) / DRAWS;
    k += pow((c.extinction - 0.23) / c.extinction_sigma, 2) / DRAWS;
    chi2 += c.chi2 / DRAWS;
    for (int i = 0; i < 3; i++) {
      double x = 1.0 + 0.9 * i, truth = 0.5 * pow(10.0, -0.4 * 0.23 * x);
      double got = um_instrument_calibration_factor(&c, x, &relative);
      factor[i] += pow((got / truth - 1.0) / relative, 2) / DRAWS;
    }
  }
  print_message("mean squares: kappa %.3f, k %.3f, factor %.3f %.3f %.3f; chi2 %.2f of %d\n", kappa,
                k, factor[0], factor[1], factor[2], chi2, STARS - 2);
  assert_close(kappa, 1.0, 0.28);
  assert_close(k, 1.0, 0.28);
  for (int i = 0; i < 3; i++) assert_close(factor[i], 1.0, 0.28);
  assert_close(chi2, STARS - 2, 4.0 * sqrt(2.0 * (STARS - 2) / DRAWS));
}

static void refused(const struct um_instrument_star *star, size_t n, double extinction,
                    const char *message, size_t wanted)
{
  struct um_instrument_calibration c;
  size_t at;
  assert_int_equal(um_instrument_calibrate(context, star, n, extinction, &c, &at), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), message);
  assert_int_equal(at, wanted);
  um_core_message_clear(context);
}

static void test_refused(void **state)
{
  (void)state;
  struct um_instrument_star star[STARS];
  make(star, 0);
  refused(star, 1, NAN, "1 stars; accepted: 2 or more", 1);
  refused(star, 0, 0.2, "0 stars; accepted: 1 or more", 0);
  star[1].airmass = star[0].airmass;
  refused(star, 2, NAN,
          "all stars stand at airmass 1: the extinction is not determined; accepted: stars at "
          "several airmasses, or a known extinction",
          2);
  star[0] = (struct um_instrument_star){1.1, 1e300, 1e-300, 1e-300};
  star[1] = (struct um_instrument_star){38.0, 1e-300, 1e300, 1e300};
  refused(star, 2, 0.2,
          "counts so far from what is predicted that they give no factor; accepted: counts as of "
          "this telescope, with their own sigma",
          2);
  star[0] = (struct um_instrument_star){1.0, 1.0, 0.1, 1.0};
  star[1] = (struct um_instrument_star){1.1, 0.1, 0.01, 1.0}; /* 2.5 mag in 0.1 airmass */
  refused(star, 2, NAN,
          "the stars give an extinction of 25 +- 1.53546 mag per airmass; accepted: -10 to 10, "
          "stars at airmasses further apart, or a known extinction",
          2);
  make(star, 0);
  star[3].measured = -2.0;
  star[3].sigma = 3.0;
  star[3].predicted = 10.0;
  star[3].airmass = 1.5;
  refused(star, STARS, NAN, "-2 +- 3 counts per second of 10 at airmass 1.5; accepted: all above 0",
          3);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_what_is_put_in),
      cmocka_unit_test(test_uneven),
      cmocka_unit_test(test_scatter),
      cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
