/* umbra synth and umbra compare: the files they make, and that what is wrong is said in one line
 * and leaves nothing behind. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/json.h"
#include "tests/app/table.h"

#define HEAD "time_utc,quantity,of,value,sigma\n"

static int enter(void **state)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  return 0;
}

#define SYNTH(file, ...)                                                                           \
  "synth", "box.yaml", "--noise", "0.01,0.001", "-o", file, "--temperatures", "bus,+x",            \
      __VA_ARGS__, NULL

static void assert_same_file(const char *a, const char *b, bool same)
{
  char *x = command_read(a), *y = command_read(b);
  assert_int_equal(strcmp(x, y) == 0, same);
  free(x);
  free(y);
}

/* One seed, one set of bytes, for any number of threads; an existing file stays without --force. */
static void test_synth(void **state)
{
  (void)state;
  command_expect(0, SYNTH("a.csv", "--seed", "5"));
  command_expect(0, SYNTH("b.csv", "--seed", "5", "--threads", "1"));
  command_expect(0, SYNTH("c.csv", "--seed", "6"));
  assert_same_file("a.csv", "b.csv", true);
  assert_same_file("a.csv", "c.csv", false);
  command_expect(1, SYNTH("a.csv", "--seed", "6"));
  assert_same_file("a.csv", "b.csv", true);
  command_expect(0, SYNTH("a.csv", "--seed", "6", "--force"));
  assert_same_file("a.csv", "c.csv", true);
  /* five times; the first is below the horizon, where only temperatures are measured */
  struct table t = table_read("a.csv");
  assert_string_equal(t.header, "time_utc,quantity,of,value,sigma");
  assert_int_equal(t.nrow, 4 * 2 + 5 * 2);
  assert_string_equal(table_text(&t, 0, "of"), "bus");
  assert_string_equal(table_text(&t, 2, "of"), "vis");
  for (size_t i = 0; i < t.nrow; i++) assert_true(table_number(&t, i, "sigma") > 0.0);
  table_release(&t);
}

/* The folder: metrics that belong together, a residual per row, JSON that is the same as what
 * --json prints. */
static void test_compare(void **state)
{
  (void)state;
  const char *where;
  command_expect(0, SYNTH("m.csv", "--seed", "5"));
  struct command c = command_run("compare", "box.yaml", "m.csv", "--out", "out", "--json", NULL);
  assert_int_equal(c.code, 0);
  char *json = command_read("out/compare.json");
  assert_string_equal(json, c.out);
  if (!json_is_valid(json, &where)) fail_msg("not JSON from here on: %.60s", where);
  assert_non_null(strstr(json, "\"chi2_red\": "));
  assert_non_null(strstr(json, "\"coordinate\": \"since_shadow_exit_s\""));
  assert_non_null(strstr(json, "\"mechanism_W_sr\": {\"sun\": "));
  free(json);
  command_release(&c);
  struct table r = table_read("out/residuals.csv"), m = table_read("out/metrics.csv");
  assert_int_equal(r.nrow, 18);
  for (size_t i = 0; i < r.nrow; i++) {
    double residual = table_number(&r, i, "measured") - table_number(&r, i, "model");
    double sigma = table_number(&r, i, "sigma");
    double larger = fmax(fabs(table_number(&r, i, "model")), fabs(table_number(&r, i, "measured")));
    /* nine digits of either */
    assert_true(fabs(table_number(&r, i, "residual") - residual) <= 1e-8 * larger);
    assert_true(fabs(table_number(&r, i, "residual_in_sigma") -
                     table_number(&r, i, "residual") / sigma) < 1e-7);
  }
  size_t all = 0, light = 0; /* rows by the "all" lines, and by the light segments */
  for (size_t i = 0; i < m.nrow; i++) {
    const char *segment = table_text(&m, i, "segment");
    size_t count = (size_t)table_number(&m, i, "count");
    if (strcmp(segment, "all") == 0) all += count;
    if (strcmp(segment, "umbra") == 0 || strcmp(segment, "penumbra") == 0 ||
        strcmp(segment, "sunlit") == 0)
      light += count;
  }
  assert_int_equal(all, 18);
  assert_int_equal(light, 18);
  table_release(&r);
  table_release(&m);
  /* again into its own folder, the same bytes on one thread, and the table for people */
  command_expect(0, "compare", "box.yaml", "m.csv", "--out", "two", "--threads", "1", "--no-plots",
                 NULL);
  assert_same_file("out/residuals.csv", "two/residuals.csv", true);
  assert_same_file("out/metrics.csv", "two/metrics.csv", true);
  c = command_run("compare", "box.yaml", "m.csv", "--out", "out", "--no-plots", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "band_irradiance lwir [W/m^2]"));
  assert_non_null(strstr(c.out, "all channels: chi2 "));
  command_release(&c);
}

/* Two files of the same instants: the rows of each are what they are alone, and the channels named
 * by file, or as the scenario lists them. */
static void test_sets(void **state)
{
  (void)state;
  static const char column[][12] = {"model", "residual", "time_s"};
  command_expect(0, SYNTH("a.csv", "--seed", "5"));
  command_expect(0, SYNTH("b.csv", "--seed", "6"));
  command_expect(0, "compare", "box.yaml", "b.csv", "--out", "alone", "--no-plots", NULL);
  command_expect(0, "compare", "box.yaml", "a.csv", "b.csv", "--out", "both", "--no-plots", NULL);
  struct table alone = table_read("alone/residuals.csv"), both = table_read("both/residuals.csv");
  assert_int_equal(alone.nrow, 18);
  assert_int_equal(both.nrow, 36);
  for (size_t i = 0, k = 0; i < both.nrow; i++) {
    char name[64];
    if (strstr(table_text(&both, i, "of"), "@b") == NULL) continue;
    snprintf(name, sizeof name, "%s@b", table_text(&alone, k, "of"));
    assert_string_equal(table_text(&both, i, "of"), name);
    for (size_t c = 0; c < sizeof column / sizeof column[0]; c++)
      assert_string_equal(table_text(&both, i, column[c]), table_text(&alone, k, column[c]));
    k++;
  }
  table_release(&alone);
  table_release(&both);
  struct command c =
      command_run("compare", "box.yaml", "--set", "measurements.sets.+={name: dawn, file: a.csv}",
                  "--set", "measurements.sets.+={name: dusk, file: b.csv}", "--no-plots", NULL);
  assert_int_equal(c.code, 0);
  assert_non_null(strstr(c.out, "box against a.csv, b.csv: 36 observations"));
  assert_non_null(strstr(c.out, "band_irradiance lwir@dusk [W/m^2]"));
  command_release(&c);
  c = command_run("compare", "box.yaml", NULL);
  assert_int_equal(c.code, 1);
  assert_non_null(strstr(c.err, "box.yaml: no measurements; accepted: files of them"));
  command_release(&c);
}

/* The worst interval's bias has its unit; that of magnitudes, whose table is in mag, is in flux. */
static void test_worst_has_unit(void **state)
{
  (void)state;
  static const struct {
    const char *row, *says;
  } cases[] = {{"magnitude_ab,vis,7,0.02", " flux of magnitude 0, sunlit 0."},
               {"band_irradiance,lwir,3e-12,1e-14", " W/m^2, sunlit 0."}};
  command_copy_data("box.yaml");
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char text[800] = HEAD;
    for (int k = 0; k < 8; k++) {
      size_t n = strlen(text);
      snprintf(text + n, sizeof text - n, "2016-09-06T18:10:%02dZ,%s\n", 10 + 2 * k, cases[i].row);
    }
    command_write("m.csv", text);
    struct command c =
        command_run("compare", "box.yaml", "m.csv", "--out", "out", "--no-plots", NULL);
    const char *worst = strstr(c.out, "  worst: "), *bias = worst ? strstr(worst, ", bias ") : NULL;
    if (c.code != 0 || bias == NULL) fail_msg("exit %d:\n%s%s", c.code, c.out, c.err);
    char *end;
    assert_true(isfinite(strtod(bias + strlen(", bias "), &end)));
    if (strncmp(end, cases[i].says, strlen(cases[i].says)) != 0)
      fail_msg("no '%s' in %s", cases[i].says, worst);
    command_release(&c);
  }
}

/* One line, exit 1, nothing written: neither folder nor file. */
static void refused(const char *measured, const char *says)
{
  command_write("m.csv", measured);
  failure_expect((const char *[]){"compare", "box.yaml", "m.csv", "--out", "out", NULL}, says);
}

#define T0 "2016-09-06T18:10:00Z"
#define T1 "2016-09-06T18:11:00Z"

static void test_bad_measurements(void **state)
{
  (void)state;
  refused("time,quantity,of,value,sigma\n", "m.csv: header: unknown column 'time'");
  refused(HEAD T0 ",band_irradiance,swir,1,1\n",
          "m.csv:2: column 'of': the scenario has no band 'swir'");
  refused(HEAD T0 ",temperature,wing,280,1\n",
          "m.csv:2: column 'of': the scenario has no place 'wing'");
  refused(HEAD T0 ",irradiance,vis,1,1\n", "m.csv:2: column 'quantity': unknown quantity");
  refused(HEAD T0 ",count_rate,ufo,1,1\n",
          "m.csv:2: column 'of': 'ufo' is not a sensor: the scenario has none");
  refused(HEAD T1 ",temperature,bus,280,1\n" T0 ",temperature,bus,280,1\n",
          "m.csv:3: column 'time_utc': 2016-09-06T18:10:00.000Z is before");
  refused(HEAD T0 ",temperature,bus,280,1\n2017-09-06T18:10:00Z,temperature,bus,280,1\n",
          "m.csv:3: column 'time_utc': 2017-09-06T18:10:00.000Z is outside the scenario");
  refused(HEAD "2016-09-06T18:07:00Z,band_irradiance,vis,1,1\n",
          "m.csv:2: column 'time_utc': the satellite is below the horizon");
  refused(HEAD T0 ",temperature,bus,280,1\n" T0 ",temperature,bus,281,1\n",
          "m.csv:3: column 'time_utc': second row");
  refused(HEAD T0 ",temperature,bus,nan,1\n", "m.csv:2: column 'value'");
  refused(HEAD T0 ",temperature,bus,280,0\n", "m.csv:2: column 'sigma'");
  refused(HEAD, "m.csv: no measurements");
}

/* ---- pictures ---- */

/* Three passes with hours between, on one of which a second channel is measured more densely; three
 * faint outliers. */
static void write_passes(void)
{
  static const char *const format = "2016-09-06T%02d:%02d:%02dZ,%s,%.6g,%g,%s\n";
  FILE *file = fopen("m.csv", "w");
  assert_non_null(file);
  fputs("time_utc,quantity,of,value,sigma,track\n", file);
  for (int i = 0; i < 60; i++) { /* 18:08:10 on, 19:50:10 on, 21:31:10 on: every 20 s */
    int pass = i / 20, at = 10 + 20 * (i % 20),
        first = pass == 0   ? 18 * 60 + 8
                : pass == 1 ? 19 * 60 + 50
                            : 21 * 60 + 31;
    int minute = first + at / 60;
    double value = i == 12 ? 19.0 : i == 31 ? 21.5 : i == 50 ? 20.0 : 7.0 + 0.03 * (i % 20);
    fprintf(file, format, minute / 60, minute % 60, at % 60, "magnitude_ab,vis", value, 0.2, "a");
  }
  for (int i = 0; i < 30; i++) /* 18:10:05 on, every 10 s */
    fprintf(file, format, 18, 10 + (5 + 10 * i) / 60, (5 + 10 * i) % 60, "band_irradiance,lwir",
            1e-11 * (1.0 + 0.01 * i), 1e-13, "b");
  fclose(file);
}

#define TO "--set", "time.stop_utc=2016-09-06T21:40:00Z"

/* The picture of channel NAME up to the next, cut out of the script; the caller frees. */
static char *picture_of(const char *script, const char *name)
{
  char text[100];
  snprintf(text, sizeof text, "set output '%s'", name);
  const char *from = strstr(script, text);
  if (from == NULL) fail_msg("no %s", text);
  const char *to = strstr(from + 1, "set output");
  return strndup(from, (size_t)(to - from));
}

/* Rows of $curve0 [unit of the axis]: how many, and the largest step within a pass and of gaps. */
static void read_curve(const char *picture, size_t *rows, size_t *gaps, double *within)
{
  const char *at = strstr(picture, "$curve0 << EOD\n");
  assert_non_null(at);
  double t, value, last = NAN;
  *rows = *gaps = 0;
  *within = 0.0;
  for (at = strchr(at, '\n') + 1; strncmp(at, "EOD", 3) != 0; at = strchr(at, '\n') + 1) {
    if (*at == '\n') {
      assert_true(isfinite(last));
      last = NAN;
      (*gaps)++;
      continue;
    }
    assert_int_equal(sscanf(at, "%lf,%lf\n", &t, &value), 2);
    if (!isnan(last)) *within = fmax(*within, t - last);
    last = t;
    (*rows)++;
  }
}

/* First second after 18:09:30 at which more than `least` of the Sun is seen, from a run. */
static double edge_of(double least)
{
  struct table t = table_read("edge/lightcurve.csv");
  size_t k = 0;
  while (table_number(&t, k, "sunlit_fraction") <= least) k++;
  double second = strtod(table_text(&t, k, "time_utc") + 17, NULL);
  double minute = strtod(table_text(&t, k, "time_utc") + 14, NULL);
  table_release(&t);
  return 60.0 * (minute - 8.0) + second - 10.0; /* after 18:08:10 */
}

/* The axis is that of the measurements without three outliers, which are counted; magnitudes rise
 * downwards. The model is a curve per pass, of every instant at which it was computed; umbra and
 * penumbra end where a run says so, between measurements too. */
static void test_picture(void **state)
{
  (void)state;
  write_passes();
  command_expect(0, "compare", "box.yaml", "m.csv", "--out", "out", TO, NULL);
  command_expect(0, "run", "box.yaml", "--out", "edge", "--no-plots", "--set",
                 "time.start_utc=2016-09-06T18:09:30Z", "--set",
                 "time.stop_utc=2016-09-06T18:11:10Z", "--set", "time.step_s=0.25", NULL);
  char *script = command_read("out/plots.gp"), *picture = picture_of(script, "magnitude_ab_vis");
  double from, to, within;
  size_t rows, gaps;
  assert_int_equal(sscanf(strstr(picture, "set yrange ["), "set yrange [%lf:%lf]", &from, &to), 2);
  print_message("axis from %g to %g mag\n", from, to);
  assert_true(from > to && to > 4.0 && to < 7.0 && from > 7.57 && from < 12.0);
  assert_non_null(strstr(picture, "'3 beyond the axis, to 21.5'"));
  read_curve(picture, &rows, &gaps, &within);
  assert_true(rows >= 60 + 30 && gaps >= 2); /* all but what the umbra leaves without light */
  double unit = strstr(picture, "'hours after") != NULL ? 3600.0 : 60.0; /* of the axis [s] */
  assert_true(unit * within <= 20.0 + 1e-3);
  assert_non_null(strstr(picture, "$curve0 using 1:($2/1) with linespoints"));
  double umbra, penumbra, begin;
  const char *box = strstr(picture, "set object 1 rectangle from first ");
  assert_int_equal(
      sscanf(box, "set object 1 rectangle from first %lf, graph 0 to first %lf,", &begin, &umbra),
      2);
  box = strstr(picture, "set object 2 rectangle from first ");
  assert_int_equal(sscanf(box, "set object 2 rectangle from first %lf, graph 0 to first %lf,",
                          &begin, &penumbra),
                   2);
  print_message("umbra ends %.3f s, penumbra %.3f s after the first observation\n", unit * umbra,
                unit * penumbra);
  assert_true(fabs(unit * umbra - edge_of(1e-3)) <= 0.27);
  assert_true(fabs(unit * penumbra - edge_of(0.999)) <= 0.27);
  /* the eclipses of the next two revolutions, of which nothing was measured but the ends */
  assert_non_null(strstr(picture, "set object 8 "));
  assert_null(strstr(picture, "set object 9 "));
  free(picture);
  free(script);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_synth, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_compare, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_sets, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_picture, enter, command_leave),
      cmocka_unit_test_setup_teardown(test_worst_has_unit, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_bad_measurements, enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
