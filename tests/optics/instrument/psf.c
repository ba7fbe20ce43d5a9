/* Point spread functions against closed forms of their encircled energy (docs/physics/noise.md for
 * the Gaussian; Rayleigh 1881 for the round aperture). */
#include "optics/instrument/psf.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

/* 2 pi int psf r dr by Simpson's rule. */
static double integral(const struct um_instrument_psf *psf, double radius)
{
  int n = 20000;
  double sum = 0.0, h = radius / n;
  for (int i = 0; i <= n; i++)
    sum += (i == 0 || i == n ? 1.0
            : i % 2 == 1     ? 4.0
                             : 2.0) *
           i * h * um_instrument_psf_at(psf, i * h);
  return 2.0 * UM_PI * sum * h / 3.0;
}

/* Values of docs/physics/noise.md, and those of Airy's dark rings: 0.8378, 0.9099, 0.9376
 * within 1.2197, 2.2331, 3.2383 lambda/D (Born & Wolf, table 8.2). The function and its encircled
 * energy are one: the integral of the one is the other to 1e-6. With an obstruction of 0.485 (a
 * 17-inch Dall-Kirkham) less stands in the middle and all of it comes together in the end. */
static void test_encircled(void **state)
{
  (void)state;
  struct um_instrument_psf gauss = {.kind = UM_PSF_GAUSSIAN, .fwhm = 2.0};
  struct um_instrument_psf moffat = {.kind = UM_PSF_MOFFAT, .fwhm = 2.0, .beta = 4.765};
  struct um_instrument_psf airy = {.kind = UM_PSF_AIRY, .diffraction = 0.5};
  struct um_instrument_psf ring = {.kind = UM_PSF_AIRY, .diffraction = 0.5, .obstruction = 0.485};
  const double gauss_d7[3][2] = {{0.5, 0.5}, {1.0, 0.9375}, {1.5, 0.998047}};
  const double airy_dark[3][2] = {{1.2197, 0.8378}, {2.2331, 0.9099}, {3.2383, 0.9376}};
  for (int i = 0; i < 3; i++) {
    assert_true(fabs(um_instrument_psf_encircled(&gauss, 2.0 * gauss_d7[i][0]) - gauss_d7[i][1]) <=
                5e-7);
    assert_true(fabs(um_instrument_psf_encircled(&airy, 0.5 * airy_dark[i][0]) - airy_dark[i][1]) <=
                1e-4);
    assert_true(um_instrument_psf_at(&airy, 0.5 * airy_dark[i][0]) <
                1e-7 * um_instrument_psf_at(&airy, 0.0));
  }
  const struct um_instrument_psf *all[] = {&gauss, &moffat, &airy, &ring};
  for (int k = 0; k < 4; k++)
    for (double r = 0.3; r < 6.0; r += 0.9)
      assert_true(fabs(integral(all[k], r) - um_instrument_psf_encircled(all[k], r)) <= 1e-6);
  /* half of the peak at half the FWHM; 1.028 lambda/D of a full aperture, docs/physics/noise.md */
  assert_true(fabs(um_instrument_psf_at(&moffat, 1.0) / um_instrument_psf_at(&moffat, 0.0) - 0.5) <
              1e-12);
  assert_true(
      fabs(um_instrument_psf_at(&airy, 0.5 * 1.0290 * 0.5) / um_instrument_psf_at(&airy, 0.0) -
           0.5) < 1e-3);
  assert_true(um_instrument_psf_encircled(&ring, 0.6) < um_instrument_psf_encircled(&airy, 0.6));
  assert_true(um_instrument_psf_encircled(&ring, 200.0) > 0.998);
}

/* Cells add up to the square's integral: of a Gaussian erf^2, of the others between the circles in
 * and about the square, and along a circle that cuts them to what the encircled energy says (cells
 * of a fortieth of the FWHM, those whose middle lies inside: within 1 %). */
static void test_kernel(void **state)
{
  (void)state;
  const struct um_instrument_psf all[] = {
      {.kind = UM_PSF_GAUSSIAN, .fwhm = 2.0},
      {.kind = UM_PSF_MOFFAT, .fwhm = 2.0, .beta = 4.765},
      {.kind = UM_PSF_AIRY, .diffraction = 2.0},
      {.kind = UM_PSF_AIRY, .diffraction = 2.0, .obstruction = 0.485}};
  for (int k = 0; k < 4; k++) {
    struct um_instrument_kernel kernel;
    double radius = 2.0, sum = 0.0;
    assert_int_equal(um_instrument_kernel_create(context, &all[k], 0.05, 0.95, &kernel), UM_OK);
    int side = 2 * kernel.half + 1;
    double edge = (kernel.half + 0.5) * 0.05;
    assert_true(kernel.sum >= um_instrument_psf_encircled(&all[k], edge) - 1e-6);
    assert_true(kernel.sum <= um_instrument_psf_encircled(&all[k], sqrt(2.0) * edge) + 1e-6);
    for (int y = 0; y < side; y++)
      for (int x = 0; x < side; x++)
        if (hypot(x - kernel.half, y - kernel.half) * 0.05 < radius)
          sum += kernel.share[y * side + x];
    print_message("kernel of %d cells: %.6f, within %.1f arcsec %.5f\n", side, kernel.sum, radius,
                  sum);
    assert_true(fabs(sum - um_instrument_psf_encircled(&all[k], radius)) <= 0.01);
    if (k == 0) {
      double axis = erf(2.0 * sqrt(log(2.0)) * edge / 2.0);
      assert_true(fabs(kernel.sum - axis * axis) <= 1e-12);
    }
    um_instrument_kernel_clear(context, &kernel);
  }
  struct um_instrument_kernel none;
  assert_int_equal(um_instrument_kernel_create(context, &all[0], 5.0, 0.95, &none), UM_ERR_INPUT);
  assert_null(none.share);
}

/* r0 of 10 cm at 500 nm: 0.976 x 5e-7/0.1 = 1.0066 arcsec; at airmass 2 2^0.6 times that, at 10 um
 * 20^-0.2 times (seeing shrinks slowly with wavelength). */
static void test_seeing(void **state)
{
  (void)state;
  double zenith = um_instrument_seeing_fwhm(0.1, 5e-7, 1.0);
  assert_true(fabs(zenith - 1.00657) <= 1e-5);
  assert_true(fabs(um_instrument_seeing_fwhm(0.1, 5e-7, 2.0) / zenith - 1.5157166) <= 1e-6);
  assert_true(fabs(um_instrument_seeing_fwhm(0.1, 1e-5, 1.0) / zenith - 0.5492803) <= 1e-6);
}

static void write(const char *path, const char *text)
{
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
}

/* A cone of radius 3: within r the share 3 (r/R)^2 - 2 (r/R)^3. Bad files are refused by line. */
static void test_table(void **state)
{
  (void)state;
  char folder[UM_TEST_PATH], path[UM_TEST_PATH + 16];
  static const struct {
    const char *text, *says;
  } bad[] = {
      {"radius_arcsec,value\n0,1\n1,-1\n", "psf.csv:3: column 'value': -1; accepted: 0 or above"},
      {"radius_arcsec,value\n1,1\n2,1\n",
       "psf.csv:2: column 'radius_arcsec': 1 arcsec; accepted: 0 first"},
      {"radius_arcsec,value\n0,1\n2,1\n2,0\n", "psf.csv:4: column 'radius_arcsec': 2 arcsec; "},
      {"radius_arcsec,value\n0,0\n2,0\n", "psf.csv: its integral is 0; accepted: 1e-290 to "},
      {"radius_arcsec,value\n0,1\n", "1 rows; accepted: 2 to "},
      {"radius_arcsec,value\n0,1\n1,nan\n", "psf.csv:3: column 'value': 'nan' is not a finite"},
      {"radius,value\n0,1\n1,0\n", "radius_arcsec"}};
  struct um_instrument_psf psf;
  assert_int_equal(um_test_folder_create(folder), 0);
  snprintf(path, sizeof path, "%s/psf.csv", folder);
  write(path, "radius_arcsec,value\n0,7\n3,0\n");
  assert_int_equal(um_instrument_psf_read(context, path, &psf), UM_OK);
  for (double q = 0.1; q < 1.2; q += 0.2) {
    double share = q < 1.0 ? 3.0 * q * q - 2.0 * q * q * q : 1.0;
    assert_true(fabs(um_instrument_psf_encircled(&psf, 3.0 * q) - share) <= 1e-12);
  }
  assert_true(fabs(integral(&psf, 3.0) - 1.0) <= 1e-6);
  um_instrument_psf_clear(context, &psf);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    write(path, bad[i].text);
    um_core_message_clear(context);
    assert_int_equal(um_instrument_psf_read(context, path, &psf), UM_ERR_INPUT);
    if (strstr(um_core_message(context), bad[i].says) == NULL)
      fail_msg("%s", um_core_message(context));
  }
  remove(path);
  assert_int_equal(um_test_folder_remove(folder), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_encircled),
      cmocka_unit_test_setup_teardown(test_kernel, context_set_up, context_tear_down),
      cmocka_unit_test(test_seeing),
      cmocka_unit_test_setup_teardown(test_table, context_set_up, context_tear_down),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
