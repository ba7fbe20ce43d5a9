/* umbra photometry and umbra calibrate, by way of frames of umbra render and back: a pass whose
 * telescope lets through half of what is stated under air of 0.2 mag per airmass, with two stars in
 * every frame. The stars give the factor and the extinction, the frames counts, and calibrated they
 * are what the scenario, which knows of neither, says of the satellite. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/table.h"

#define FRAMES 6

static const char *const moment[FRAMES] = {"2016-09-06T18:11:00Z", "2016-09-06T18:12:00Z",
                                           "2016-09-06T18:12:40Z", "2016-09-06T18:13:20Z",
                                           "2016-09-06T18:14:00Z", "2016-09-06T18:15:00Z"};
static const char *const file[FRAMES] = {"f0.fits", "f1.fits", "f2.fits",
                                         "f3.fits", "f4.fits", "f5.fits"};

static void write_scenario(void)
{
  command_copy_data("box.yaml");
  char *text = command_read("box.yaml"), *at = strstr(text, "18:11:00Z");
  FILE *out = fopen("eye.yaml", "w");
  assert_non_null(at);
  assert_non_null(out);
  memcpy(at, "18:16:00Z", 9);
  fprintf(out,
          "%s\nsensors:\n  eye: {band: vis, aperture_m: 0.5, throughput: 0.1, gain_e: 2, "
          "exposure_s: 0.5, pixel_arcsec: 0.7, fwhm_arcsec: 2, dark_e_s: 8, read_noise_e: 3, "
          "sky_mag_arcsec2: 19, saturation_e: 200000}\n",
          text);
  assert_int_equal(fclose(out), 0);
  free(text);
}

/* Frames of 0.5 of the light, each with noise of its own; the stars at the corners make them all of
 * one size. */
static void expose(int draw)
{
  for (int i = 0; i < FRAMES; i++) {
    char seed[16];
    snprintf(seed, sizeof seed, "%d", FRAMES * draw + i);
    command_expect(0, "render", "eye.yaml", "--time", moment[i], "--sensor", "eye", "--with",
                   "zero_point:vis,factor=0.5", "--with", "extinction:vis,k_mag=0.2", "--star",
                   "7.5,40,30", "--star", "8.5,-40,-30", "--width", "32", "--samples", "4",
                   "--border", "16", "--seed", seed, "--no-plots", "-o", file[i], "--force", NULL);
  }
}

/* A number of a card of a FITS header. */
static double card(const char *path, const char *key)
{
  size_t n;
  char name[10], *bytes = command_read_bytes(path, &n);
  double value = NAN;
  snprintf(name, sizeof name, "%-8s=", key);
  for (size_t i = 0; i + 80 <= n && isnan(value); i += 80)
    if (strncmp(bytes + i, name, 9) == 0) value = strtod(bytes + i + 10, NULL);
  free(bytes);
  assert_true(value == value); /* the card is there */
  return value;
}

static double number_behind(const char *text, const char *word)
{
  const char *at = strstr(text, word);
  assert_non_null(at);
  return strtod(at + strlen(word), NULL);
}

#define APERTURE "--aperture", "9,12,18"
#define ALL      file[0], file[1], file[2], file[3], file[4], file[5]

static void test_there_and_back(void **state)
{
  (void)state;
  enum { SEEDS = 5 };
  double kappa2 = 0.0, k2 = 0.0, chi2 = 0.0, rows = 0.0;
  write_scenario();
  for (int draw = 1; draw <= SEEDS; draw++) {
    char text[2][64];
    expose(draw);
    for (int s = 0; s < 2; s++)
      snprintf(text[s], sizeof text[s], "%g,%.3f,%.3f", card(file[0], s == 0 ? "STARM1" : "STARM2"),
               card(file[0], s == 0 ? "STARX1" : "STARX2"),
               card(file[0], s == 0 ? "STARY1" : "STARY2"));
    command_expect(0, "photometry", ALL, APERTURE, "--star", text[0], "--star", text[1], "-o",
                   "stars.csv", "--force", NULL);
    command_expect(0, "photometry", ALL, APERTURE, "-o", "measured.csv", "--force", NULL);
    struct command c = command_run("calibrate", "eye.yaml", "stars.csv", "measured.csv", "--sensor",
                                   "eye", "-o", "calibrated.csv", "--force", NULL);
    assert_int_equal(c.code, 0);
    double kappa = number_behind(c.out, "kappa "), k = number_behind(c.out, "extinction ");
    const char *second = strstr(c.out, "extinction ");
    kappa2 += pow((kappa - 0.5) / number_behind(c.out, "+- "), 2) / SEEDS;
    k2 += pow((k - 0.2) / number_behind(second, "+- "), 2) / SEEDS;
    assert_close(kappa, 0.5, 0.01);
    assert_close(k, 0.2, 0.01);
    command_release(&c);
    command_expect(0, "compare", "eye.yaml", "calibrated.csv", "--no-plots", "--out", "compared",
                   "--force", NULL);
    struct table t = table_read("compared/residuals.csv");
    assert_int_equal(t.nrow, FRAMES);
    for (size_t i = 0; i < t.nrow; i++) {
      double measured = table_number(&t, i, "measured"), model = table_number(&t, i, "model");
      double sigma = table_number(&t, i, "sigma");
      chi2 += pow((measured - model) / sigma, 2);
      rows += 1.0;
      assert_close(measured / model, 1.0, 0.02);
    }
    table_release(&t);
  }
  print_message("mean squares: kappa %.2f, extinction %.2f; calibrated counts: chi2 %.1f of %.0f\n",
                kappa2, k2, chi2, rows);
  /* five draws: a mean square of 4 has a probability of 0.1 % */
  assert_true(kappa2 < 4.0 && k2 < 4.0);
  /* rows of a draw share the error of the factor */
  assert_true(chi2 > 0.2 * rows && chi2 < 2.5 * rows);
}

/* Whole numbers of 16 bits with an offset, as cameras write them, are the same picture. */
static void write_short(const char *from, const char *to)
{
  size_t n, at = 0;
  char *bytes = command_read_bytes(from, &n);
  while (strncmp(bytes + at, "END     ", 8) != 0) at += 80;
  size_t data = (at / 2880 + 1) * 2880, pixels = 0;
  memcpy(bytes + 80, "BITPIX  =                   16", 30);
  FILE *out = fopen(to, "wb");
  assert_non_null(out);
  fwrite(bytes, 1, at, out);
  fprintf(out, "%-80s%-80s", "BZERO   =              30000.0", "END");
  for (size_t i = at + 160; i % 2880 != 0; i++) fputc(' ', out);
  pixels = (size_t)(card(from, "NAXIS1") * card(from, "NAXIS2"));
  for (size_t i = 0; i < pixels; i++) {
    const unsigned char *b = (const unsigned char *)bytes + data + 4 * i;
    unsigned bits = (unsigned)b[0] << 24 | (unsigned)b[1] << 16 | (unsigned)b[2] << 8 | b[3];
    float value;
    memcpy(&value, &bits, sizeof value);
    int whole = (int)value - 30000; /* faint pixels are below 0 */
    fputc((whole >> 8) & 255, out);
    fputc(whole & 255, out);
  }
  for (size_t i = 2 * pixels; i % 2880 != 0; i++) fputc(0, out);
  assert_int_equal(fclose(out), 0);
  free(bytes);
}

static void expose_one(const char *saturation)
{
  command_expect(0, "render", "eye.yaml", "--time", moment[3], "--sensor", "eye", "--width", "32",
                 "--samples", "4", "--border", "16", "--seed", "1", "-o", "a.fits", "--with",
                 "zero_point:vis,factor=0.1", "--set", saturation, "--force", NULL);
}

static void test_files(void **state)
{
  (void)state;
  write_scenario();
  expose_one("sensors.eye.saturation_e=200000");
  assert_true(command_exists("a.png"));
  assert_false(command_exists("a.svg"));
  write_short("a.fits", "b.fits");
  command_expect(0, "photometry", "a.fits", APERTURE, "--sky", "median", "-o", "a.csv", NULL);
  command_expect(0, "photometry", "b.fits", APERTURE, "--sky", "median", "-o", "b.csv", NULL);
  char *a = command_read("a.csv"), *b = command_read("b.csv");
  assert_string_equal(a, b);
  assert_non_null(strstr(a, "count_rate,eye,"));
  free(a);
  free(b);
  struct table t = table_read("a.csv");
  double rate = table_number(&t, 0, "value");
  table_release(&t);
  command_expect(0, "run", "eye.yaml", "--no-plots", "--out", "out", "--set",
                 "time.start_utc=2016-09-06T18:13:20Z", "--set",
                 "time.stop_utc=2016-09-06T18:13:20Z", NULL);
  t = table_read("out/counts.csv");
  assert_close(rate / table_number(&t, 0, "eye_count_rate_1_s"), 0.1, 0.002);
  table_release(&t);
  /* a bright pixel of a full well: flagged */
  expose_one("sensors.eye.saturation_e=2000");
  command_expect(0, "photometry", "a.fits", APERTURE, "-o", "c.csv", NULL);
  t = table_read("c.csv");
  assert_string_equal(table_text(&t, 0, "flag"), "1");
  table_release(&t);
}

static void test_refused(void **state)
{
  (void)state;
  static const struct failure cases[] = {
      {{"photometry", "a.fits", "--aperture", "9,12,80", "-o", "x.csv"},
       "a.fits: the annulus of 80"},
      {{"photometry", "a.fits", "--aperture", "9,12", "-o", "x.csv"},
       "--aperture 9,12; accepted: R"},
      {{"photometry", "a.fits", APERTURE, "--at", "3,3", "-o", "x.csv"}, "about 3,3 leaves the"},
      {{"photometry", "a.fits", APERTURE, "--sky", "mode", "-o", "x.csv"},
       "accepted: mean, median"},
      {{"photometry", "eye.yaml", APERTURE, "-o", "x.csv"}, "eye.yaml: is no FITS file"},
      {{"photometry", "cut.fits", APERTURE, "-o", "x.csv"}, "cut.fits: ends before its"},
      {{"photometry", "a.fits", APERTURE, "--star", "7,3", "-o", "x.csv"}, "accepted: MAG,X,Y"},
      {{"calibrate", "eye.yaml", "one.csv", "--sensor", "eye"}, "one.csv: 1 stars; accepted: 2"},
      {{"calibrate", "eye.yaml", "level.csv", "--sensor", "eye"},
       "level.csv: all stars stand at airmass 1.5: the extinction is not determined"},
      {{"calibrate", "eye.yaml", "bad.csv", "--sensor", "eye"}, "bad.csv:3: -5 +- 1 counts"},
      {{"calibrate", "eye.yaml", "level.csv", "--sensor", "ear"}, "--sensor: the scenario has no"},
      {{"calibrate", "eye.yaml", "level.csv", "--sensor", "eye", "-o", "x.csv"},
       "-o without MEASURED; accepted: both"},
  };
  write_scenario();
  expose_one("sensors.eye.saturation_e=200000");
  size_t n;
  char *bytes = command_read_bytes("a.fits", &n);
  FILE *cut = fopen("cut.fits", "wb");
  assert_non_null(cut);
  fwrite(bytes, 1, 5760, cut);
  assert_int_equal(fclose(cut), 0);
  free(bytes);
#define STARS "magnitude_ab,airmass,count_rate,sigma\n"
  command_write("one.csv", STARS "8,1.5,1e5,1e3\n");
  command_write("level.csv", STARS "8,1.5,1e5,1e3\n9,1.5,4e4,1e3\n");
  command_write("bad.csv", STARS "8,1.5,1e5,1e3\n9,1.2,-5,1\n");
  failures_expect(cases, sizeof cases / sizeof cases[0]);
  /* a known extinction needs no second airmass */
  command_expect(0, "calibrate", "eye.yaml", "level.csv", "--sensor", "eye", "--extinction", "0.2",
                 NULL);
}

/* A frame of 32 x 32 zeros with these values of INSTRUME and DATE-AVG, as they stand. */
static void write_header(const char *path, const char *instrument, const char *date)
{
  const char *card[] = {"SIMPLE  =                    T",
                        "BITPIX  =                    8",
                        "NAXIS   =                    2",
                        "NAXIS1  =                   32",
                        "NAXIS2  =                   32",
                        "EXPTIME = 1.0",
                        "GAIN    = 1.0",
                        "RDNOISE = 1.0",
                        "AIRMASS = 1.5",
                        NULL,
                        NULL,
                        "END"};
  char text[2][96];
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  snprintf(text[0], sizeof text[0], "INSTRUME= '%s'", instrument);
  snprintf(text[1], sizeof text[1], "DATE-AVG= '%s'", date);
  card[9] = text[0];
  card[10] = text[1];
  for (size_t i = 0; i < 36; i++) fprintf(out, "%-80.80s", i < 12 ? card[i] : "");
  for (int i = 0; i < 2880; i++) fputc(0, out);
  assert_int_equal(fclose(out), 0);
}

static bool holds_control(const char *text)
{
  for (; *text != '\0'; text++)
    if (((unsigned char)*text < 0x20 && *text != '\n') || *text == 0x7f) return true;
  return false;
}

/* Texts of a header reach a terminal and a table only as what the standard allows, and as nothing
 * that a terminal or a spreadsheet obeys; those that are names are quoted where they have to be. */
static void test_header_texts(void **state)
{
  (void)state;
  static const char when[] = "2016-09-21T20:33:00";
  static const struct {
    const char *path, *instrument, *date, *says;
  } refused[] = {
      {"x.fits", "\x1b[31mX\x1b]0;pwn\x07", when,
       "x.fits: INSTRUME holds the byte 0x1b; accepted: "},
      {"x.fits", "caf\xe9", when, "x.fits: INSTRUME holds the byte 0xe9; accepted: "},
      {"x.fits", "\x7f", when, "x.fits: INSTRUME holds the byte 0x7f; accepted: printable ASCII"},
      {"x.fits", "=cmd|'' /C calc''!A0", when,
       "x.fits: INSTRUME is '=cmd|' /C calc'!A0'; accepted: a name "},
      {"x.fits", "@SUM(1)", when, "its first character none of = + - @"},
      {"x.fits", "-2+3", when, "its first character none of = + - @"},
      {"x.fits", "+1", when, "its first character none of = + - @"},
      {"x.fits", "a \"b\"", when, "x.fits: INSTRUME is 'a \"b\"'; accepted: a name "},
      {"x.fits", "eye", "\x1b[2J\xc2\x9b", "x.fits: DATE-AVG: ' [2J\?\?' is not a UTC time"},
      {"\x1b[2J.fits", "=1", when, " [2J.fits: INSTRUME is '=1'; accepted: a name "},
  };
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    write_header(refused[i].path, refused[i].instrument, refused[i].date);
    struct command c =
        command_run("photometry", refused[i].path, "--aperture", "3,5,8", "-o", "m.csv", NULL);
    if (c.code != 1 || c.out[0] != '\0' || strstr(c.err, refused[i].says) == NULL ||
        holds_control(c.err) || command_exists("m.csv"))
      fail_msg("case %zu: exit %d, expected 1 and '%s':\n%s%s", i, c.code, refused[i].says, c.out,
               c.err);
    command_release(&c);
  }
  write_header("y\x1b[2J.fits", "eye, O''Brien", when);
  struct command c =
      command_run("photometry", "y\x1b[2J.fits", "--aperture", "3,5,8", "-o", "m.csv", NULL);
  assert_int_equal(c.code, 0);
  assert_false(holds_control(c.out) || holds_control(c.err));
  assert_non_null(strstr(c.out, "  y?[2J.fits\n"));
  command_release(&c);
  char *table = command_read("m.csv");
  assert_non_null(strstr(table, ",count_rate,\"eye, O'Brien\",0,"));
  free(table);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_header_texts, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_there_and_back, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_files, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
