/* Frames of a detector as FITS, read back by the standard's own words (blocks of 2880 bytes, cards
 * of 80, big-endian numbers), held against the counts of the same run. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/table.h"

#define MOMENT "2016-09-06T18:10:30Z"
#define FRAME  "render", "eye.yaml", "--time", MOMENT, "--width", "64", "--samples", "4"

/* The box with a telescope that keeps all of its light: a large saturation, a dark sky. */
static void write_scenario(void)
{
  command_copy_data("box.yaml");
  char *text = command_read("box.yaml");
  FILE *file = fopen("eye.yaml", "w");
  assert_non_null(file);
  fprintf(file,
          "%s\nsensors:\n  eye: {band: vis, aperture_m: 0.5, gain_e: 2, exposure_s: 0.5, "
          "pixel_arcsec: 0.7, fwhm_arcsec: 2, dark_e_s: 8, read_noise_e: 3}\n"
          "  blind: {band: vis, aperture_m: 0.5, exposure_s: 0.5}\n",
          text);
  assert_int_equal(fclose(file), 0);
  free(text);
}

struct fits {
  char *bytes;
  size_t n;
  int width, height;
  const unsigned char *data;
};

/* Number of a card. */
static double card(const struct fits *f, const char *key)
{
  char name[10];
  snprintf(name, sizeof name, "%-8s=", key);
  for (size_t i = 0; i + 80 <= f->n; i += 80) {
    if (strncmp(f->bytes + i, name, 9) == 0) return strtod(f->bytes + i + 10, NULL);
    if (strncmp(f->bytes + i, "END     ", 8) == 0) break;
  }
  fail_msg("no card %s", key);
  return NAN;
}

static struct fits read_fits(const char *path)
{
  struct fits f = {0};
  f.bytes = command_read_bytes(path, &f.n);
  assert_true(f.n % 2880 == 0);
  assert_true(strncmp(f.bytes, "SIMPLE  =                    T", 30) == 0);
  assert_true(card(&f, "BITPIX") == -32.0 && card(&f, "NAXIS") == 2.0);
  f.width = (int)card(&f, "NAXIS1");
  f.height = (int)card(&f, "NAXIS2");
  size_t at = 0;
  while (strncmp(f.bytes + at, "END     ", 8) != 0) at += 80;
  at = (at / 2880 + 1) * 2880;
  assert_true(f.n >= at + 4 * (size_t)f.width * (size_t)f.height);
  f.data = (const unsigned char *)f.bytes + at;
  return f;
}

static double pixel(const struct fits *f, int i)
{
  const unsigned char *b = f->data + 4 * i;
  unsigned bits = (unsigned)b[0] << 24 | (unsigned)b[1] << 16 | (unsigned)b[2] << 8 | b[3];
  float value;
  memcpy(&value, &bits, sizeof value);
  return (double)value;
}

/* Expected counts: what the frame holds above its background is the run's count rate times the
 * exposure, to the 1e-6 of light that may stand beside it and float's precision; the background is
 * the dark current. With a seed whole counts, another seed other ones, within four sigma of it. */
static void test_counts(void **state)
{
  (void)state;
  write_scenario();
  command_expect(0, "run", "eye.yaml", "--no-plots", "--out", "out", "--set",
                 "time.start_utc=" MOMENT, "--set", "time.stop_utc=" MOMENT, NULL);
  command_expect(0, FRAME, "--sensor", "eye", "-o", "a.fits", NULL);
  command_expect(0, FRAME, "--sensor", "eye", "--seed", "3", "-o", "b.fits", NULL);
  command_expect(0, FRAME, "--sensor", "eye", "--seed", "3", "--threads", "1", "-o", "c.fits",
                 NULL);
  struct table t = table_read("out/counts.csv");
  double wanted = 0.5 * table_number(&t, 0, "eye_count_rate_1_s"), sum = 0.0, drawn = 0.0;
  table_release(&t);
  struct fits a = read_fits("a.fits"), b = read_fits("b.fits"), c = read_fits("c.fits");
  assert_int_equal(a.width, b.width);
  assert_true(b.n == c.n && memcmp(b.bytes, c.bytes, b.n) == 0);
  assert_true(fabs(card(&a, "BACKGRND") - 2.0) <= 1e-9); /* 8 e/s 0.5 s/2 */
  for (int i = 0; i < a.width * a.height; i++) {
    sum += pixel(&a, i) - 2.0;
    drawn += pixel(&b, i) - 2.0;
    assert_true(pixel(&b, i) == floor(pixel(&b, i)));
  }
  print_message("%d x %d: %.7g counts, %.7g of the run, %.7g drawn\n", a.width, a.height, sum,
                wanted, drawn);
  assert_true(wanted > 0.0 && fabs(sum - wanted) <= 3e-6 * (wanted + 2.0 * a.width * a.height));
  double sigma = sqrt(wanted / 2.0 + a.width * a.height * (1.0 + 9.0 / 4.0 + 1.0 / 12.0));
  assert_true(fabs(drawn - wanted) <= 4.0 * sigma);
  free(a.bytes);
  free(b.bytes);
  free(c.bytes);
}

static void test_refused(void **state)
{
  (void)state;
  static const struct failure cases[] = {
      {{FRAME, "--sensor", "eyes", "-o", "x.fits"}, "did you mean 'eye'?; accepted: eye, blind"},
      {{FRAME, "--sensor", "blind", "-o", "x.fits"},
       "sensors.blind.pixel_arcsec: a frame needs it"},
      {{FRAME, "--sensor", "eye", "--psf", "moffat:0.9", "-o", "x.fits"}, "BETA above 1"},
      {{FRAME, "--sensor", "eye", "--psf", "none.csv", "-o", "x.fits"}, "none.csv: No such file"},
      {{FRAME, "--sensor", "eye", "--motion", "12", "-o", "x.fits"}, "accepted: RATE,ANGLE"},
      {{FRAME, "--sensor", "eye", "--seed", "x", "-o", "x.fits"}, "--seed x; accepted: a whole"},
      {{FRAME, "--sensor", "eye", "--psf", "seeing:5", "-o", "x.fits"},
       "point spread function of "},
      {{FRAME, "--sensor", "eye", "--motion", "1e5,0", "-o", "x.fits"}, "accepted: up to 4096 a "},
      {{"render", "eye.yaml", "--time", "2016-09-06T18:11:01Z", "--sensor", "eye", "-o", "x.fits"},
       "--time 2016-09-06T18:11:01Z; accepted: 2016-09-06T18:07:00.000Z to "
       "2016-09-06T18:11:00.000Z"},
      {{"render", "eye.yaml", "--time", "2016-09-06T18:06:59Z", "--sensor", "eye", "-o", "x.fits"},
       "--time 2016-09-06T18:06:59Z; accepted: 2016-09-06T18:07:00.000Z to "},
      {{FRAME, "--sensor", "eye", "-o", "x.png"},
       "x.png: no '.png' is written here; accepted: a name in .fits, .fit, .fts"},
      {{FRAME, "--sensor", "eye", "--force", "-o", "eye.yaml"}, "no '.yaml' is written here"},
  };
  write_scenario();
  failures_expect(cases, sizeof cases / sizeof cases[0]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_counts, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
