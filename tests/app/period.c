/* umbra import and umbra period: from the track of a survey to a period, and what is refused. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/json.h"
#include "tests/app/table.h"

#define PERIOD 21.37 /* [s] of the track that is written here */
#define ROWS   300   /* one a second */

/* A cosine of 0.8 mag, rounded to the hundredth as the survey writes it. */
static void write_track(void)
{
  FILE *f = fopen("track.txt", "w");
  assert_non_null(f);
  fputs("# track: 7\n# Date Time Mag Filter Penumbra Channel Track Satellite\n", f);
  for (int i = 0; i < ROWS; i++)
    fprintf(f, "2016-09-21 20:%02d:%02d.000 %.2f Clear 0 1 7 27386\n", 30 + i / 60, i % 60,
            7.0 + 0.8 * cos(2.0 * 3.14159265358979 * i / PERIOD));
  fclose(f);
}

static void test_track_to_period(void **state)
{
  (void)state;
  const char *where;
  write_track();
  command_expect(0, "import", "track.txt", "-o", "measured.csv", "--noise", "0.02", NULL);
  struct command c = command_run("period", "measured.csv", "--out", "found", "--json", NULL);
  assert_int_equal(c.code, 0);
  assert_true(json_is_valid(c.out, &where));
  const char *at = strstr(c.out, "\"period_s\": ");
  assert_non_null(at);
  /* the flux of a cosine in magnitudes is no sine, so harmonics stand beside it; over 14 turns the
   * line is 21.37 / 14 s wide and its middle is good to a hundredth of that */
  assert_true(fabs(atof(at + strlen("\"period_s\": ")) - PERIOD) <= 0.015);
  command_release(&c);
  assert_true(command_exists("found/periodogram.csv"));
  assert_true(command_exists("found/folded.csv"));
  assert_true(command_exists("found/period_magnitude_vega_Clear.png"));
  char *script = command_read("found/period.gp");
  assert_non_null(strstr(script, "set label 902 'period 21.3"));
  assert_null(strstr(script, "no period"));
  free(script);
}

/* A track that brightens and fades as a pass does, with 0.03 mag of noise (three uniform numbers),
 * without a spin: no period is named, in JSON and in words. */
static void test_no_period(void **state)
{
  (void)state;
  const char *where;
  FILE *f = fopen("track.txt", "w");
  assert_non_null(f);
  fputs("# track: 7\n# Date Time Mag Filter Penumbra Channel Track Satellite\n", f);
  unsigned short seed[3] = {1, 2, 3};
  for (int i = 0; i < ROWS; i++) {
    double u = 2.0 * i / ROWS - 1.0, noise = erand48(seed) + erand48(seed) + erand48(seed) - 1.5;
    fprintf(f, "2016-09-21 20:%02d:%02d.000 %.2f Clear 0 1 7 27386\n", 30 + i / 60, i % 60,
            7.0 + 2.5 * log10(1.0 + 3.0 * u * u) + 0.3 * u + 0.06 * noise);
  }
  fclose(f);
  command_expect(0, "import", "track.txt", "-o", "measured.csv", "--noise", "0.02", NULL);
  struct command c = command_run("period", "measured.csv", "--out", "found", "--json", NULL);
  assert_int_equal(c.code, 0);
  assert_true(json_is_valid(c.out, &where));
  assert_non_null(strstr(c.out, "\"named\": false, \"period_s\": null"));
  command_release(&c);
  char *script = command_read("found/period.gp"); /* nor in the picture */
  assert_non_null(strstr(script, "set label 902 'no period: noise peaks as high (at "));
  assert_null(strstr(script, "set label 902 'period "));
  free(script);
  c = command_run("period", "measured.csv", "--out", "found", "--no-plots", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "no period: noise peaks as high"));
  command_release(&c);
  /* folded at that peak it is level: the pass, four times as bright in its middle, is out; 7 points
   * of 3 % in a bin */
  struct table t = table_read("found/folded.csv");
  double low = INFINITY, high = 0.0;
  for (size_t b = 0; b < t.nrow; b++) {
    low = fmin(low, table_number(&t, b, "mean"));
    high = fmax(high, table_number(&t, b, "mean"));
  }
  print_message("folded from %.4g to %.4g\n", low, high);
  assert_true(low > 0.0 && high < 1.2 * low);
  table_release(&t);
}

static void test_refusals(void **state)
{
  (void)state;
  write_track();
  command_expect(0, "import", "track.txt", "-o", "measured.csv", NULL);
  char *before = command_snapshot(".");
  command_expect(1, "import", "track.txt", "-o", "measured.csv", NULL);
  command_expect(1, "import", "measured.csv", "-o", "other.csv", NULL);
  command_expect(1, "import", "nowhere.txt", "-o", "other.csv", NULL);
  command_expect(2, "import", "track.txt", NULL);
  command_expect(2, "import", "track.txt", "-o", "other.csv", "--noise", "1,2,3", NULL);
  command_expect(1, "import", "track.txt", "-o", "other.csv", "--noise", "-1", NULL);
  command_expect(1, "period", "measured.csv", "--band", "vis", "--out", "found", NULL);
  command_expect(2, "period", NULL);
  char *after = command_snapshot(".");
  assert_string_equal(before, after);
  free(before);
  free(after);
  /* a light curve that is too short, or does not vary, is named with its file */
#define ROW(second, of, value) "2016-09-06T18:10:0" second "Z,band_irradiance," of "," value ",1\n"
  command_write("few.csv", "time_utc,quantity,of,value,sigma\n" ROW("0", "vis", "1"));
  command_write("same.csv",
                "time_utc,quantity,of,value,sigma\n" ROW("0", "V", "2") ROW("1", "V", "2")
                    ROW("2", "V", "2") ROW("3", "V", "2") ROW("4", "V", "2"));
  static const struct failure cases[] = {
      {{"period", "few.csv", "--out", "found"},
       "few.csv: band_irradiance vis: period search: 1 observations; accepted: 5 or more"},
      {{"period", "same.csv", "--out", "found"},
       "same.csv: band_irradiance V: period search: all 5"},
  };
  failures_expect(cases, sizeof cases / sizeof cases[0]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_track_to_period, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_no_period, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refusals, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
