/* Pictures of a run, by the script that gnuplot draws: their files, the columns of a panel, and
 * which mechanisms have a curve. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

/* A band's panel draws from the column that the table's header calls so; gnuplot counts from 1. */
static void expect_drawn(const char *script, const char *band, const char *column)
{
  struct table t = table_read("drawn/lightcurve.csv");
  char heading[32], wanted[32];
  size_t c = 0;
  while (c < t.ncolumn && strcmp(t.field[c], column) != 0) c++;
  assert_true(c < t.ncolumn);
  snprintf(heading, sizeof heading, "'%s ", band);
  snprintf(wanted, sizeof wanted, "v(%zu)", c + 1);
  const char *panel = strstr(script, heading);
  if (panel == NULL) fail_msg("no %s in plots.gp", heading);
  const char *plot = strstr(panel, "plot 'lightcurve.csv'"), *drawn = strstr(plot, wanted);
  if (drawn == NULL || drawn > strchr(plot, '\n'))
    fail_msg("%s: %s, %s, is not drawn", band, wanted, column);
  table_release(&t);
}

/* Every mechanism that is seen beside the total, and no other, has its curve and its name: above
 * the lower end of a logarithmic axis, above a hundredth of the highest total else. Returns how
 * many. */
static size_t expect_named(const char *folder, const char *band, const char *scale)
{
  static const struct {
    const char *column, *name;
  } mechanism[] = {{"sun", "Sun"},
                   {"earth", "Earth"},
                   {"emitted", "emitted"},
                   {"interreflected", "interreflected"},
                   {"other", "Moon"}};
  char path[64], text[64];
  size_t named = 0;
  snprintf(path, sizeof path, "%s/plots.gp", folder);
  char *script = command_read(path);
  snprintf(path, sizeof path, "%s/lightcurve.csv", folder);
  struct table t = table_read(path);
  snprintf(text, sizeof text, "'%s ", band);
  char *panel = strstr(script, text), *plot = strstr(panel, "plot 'lightcurve.csv'");
  *strchr(plot, '\n') = '\0';
  const char *axis = strstr(panel, scale);
  if (axis == NULL || axis > plot) fail_msg("%s, %s: no %s in\n%s", folder, band, scale, panel);
  snprintf(text, sizeof text, "%s_intensity_W_sr", band);
  double highest = 0.0, share = strcmp(scale, "\nset logscale y") == 0 ? 1e-5 : 0.01;
  for (size_t k = 0; k < t.nrow; k++) highest = fmax(highest, table_number(&t, k, text));
  for (size_t m = 0; m < sizeof mechanism / sizeof mechanism[0]; m++) {
    double most = 0.0;
    snprintf(text, sizeof text, "%s_%s_W_sr", band, mechanism[m].column);
    for (size_t k = 0; k < t.nrow; k++) most = fmax(most, table_number(&t, k, text));
    snprintf(text, sizeof text, "(v(%zu)) with lines", 1 + table_column(&t, text));
    const char *curve = strstr(plot, text);
    snprintf(text, sizeof text, " title '%s'", mechanism[m].name);
    if ((curve != NULL) != (most > share * highest) ||
        (strstr(plot, text) != NULL) != (curve != NULL))
      fail_msg("%s, %s: '%s' reaches %g of %g in\n%s", folder, band, mechanism[m].name, most,
               highest, plot);
    named += curve != NULL;
  }
  table_release(&t);
  free(script);
  return named;
}

/* Sunlight and heat; the Moon alone in the umbra, and beside a low Sun and a bright Earth; on
 * logarithmic axes, above their lower end and below it; light between surfaces. */
static void test_mechanisms_named(void **state)
{
  (void)state;
  static const char log[] = "\nset logscale y", linear[] = "\nunset logscale y";
  static const struct {
    const char *start, *stop, *step, *outside, *attitude;
    size_t vis, lwir;
    const char *scale;
  } cases[] = {
      {"2016-09-06T18:07:00Z", "2016-09-06T18:11:00Z", "60", "grey_white", "[{lvlh: {}}]", 1, 2,
       linear},
      {"2016-09-06T18:07:00Z", "2016-09-06T18:09:00Z", "60", "grey_white", "[{lvlh: {}}]", 1, 2,
       linear},
      {"2016-09-16T20:30:00Z", "2016-09-16T20:33:00Z", "60", "grey_white", "[{lvlh: {}}]", 2, 2,
       linear},
#define SPUN(period)                                                                               \
  "[{spin: {axis_gcrs: [0.3, 0.2, 0.9], axis_body: [0, 0.6, 0.8], period_s: " period "}}]"
      {"2016-09-16T20:18:00Z", "2016-09-16T20:21:40Z", "5", "cell_silicon", SPUN("90"), 2, 2, log},
      {"2016-09-16T20:18:00Z", "2016-09-16T20:21:50Z", "5", "cell_silicon", SPUN("170"), 1, 2, log},
  };
  command_copy_data("box.yaml");
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char set[5][128];
    snprintf(set[0], sizeof set[0], "time.start_utc=%s", cases[i].start);
    snprintf(set[1], sizeof set[1], "time.stop_utc=%s", cases[i].stop);
    snprintf(set[2], sizeof set[2], "time.step_s=%s", cases[i].step);
    snprintf(set[3], sizeof set[3], "parts.bus.outside=%s", cases[i].outside);
    snprintf(set[4], sizeof set[4], "attitude=%s", cases[i].attitude);
    command_expect(0, "run", "box.yaml", "--force", "--out", "drawn", "--set", set[0], "--set",
                   set[1], "--set", set[2], "--set", set[3], "--set", set[4], NULL);
    assert_int_equal(expect_named("drawn", "vis", cases[i].scale), cases[i].vis);
    assert_int_equal(expect_named("drawn", "lwir", linear), cases[i].lwir);
  }
  command_copy_data("two_parts.yaml");
  command_expect(0, "run", "two_parts.yaml", "--out", "two", NULL);
  assert_int_equal(expect_named("two", "vis", linear), 2);
  assert_int_equal(expect_named("two", "lwir", linear), 3);
}

/* With gnuplot three pictures, each of three kinds; without it a warning and everything else. */
static void test_pictures(void **state)
{
  (void)state;
  static const char *const names[] = {"lightcurve", "temperatures", "satellite"};
  static const struct {
    const char *name, *magic;
  } kinds[] = {{"png", "\x89PNG\r\n\x1a\n"}, {"svg", "<?xml"}, {"pdf", "%PDF-"}};
  command_copy_data("box.yaml");
  struct command c = command_run("run", "box.yaml", "--out", "drawn", NULL);
  assert_int_equal(c.code, 0);
  bool gnuplot = strstr(c.err, "gnuplot is not installed") == NULL;
  if (gnuplot) assert_string_equal(c.err, "");
  for (size_t i = 0; i < 9; i++) {
    char path[64];
    size_t length;
    snprintf(path, sizeof path, "drawn/%s.%s", names[i / 3], kinds[i % 3].name);
    assert_int_equal(command_exists(path), gnuplot);
    if (!gnuplot) continue;
    char *bytes = command_read_bytes(path, &length);
    assert_true(length > 1000 &&
                memcmp(bytes, kinds[i % 3].magic, strlen(kinds[i % 3].magic)) == 0);
    free(bytes);
  }
  if (!gnuplot) print_message("gnuplot is not installed: pictures not looked at\n");
  command_release(&c);
  /* magnitudes of the visible band alone, from its own column (the ninth of its nine) */
  char *script = command_read("drawn/plots.gp");
  char *first = strstr(script, "'AB magnitude'");
  assert_non_null(first);
  assert_null(strstr(first + 1, "'AB magnitude'"));
  assert_non_null(strstr(first, "using (x(1)):17 with lines"));
  assert_non_null(strstr(script, "vis 0.38–0.78 µm"));
  expect_drawn(script, "vis", "vis_sun_W_sr");
  expect_drawn(script, "lwir", "lwir_intensity_W_sr");
  expect_drawn(script, "lwir", "lwir_stderr_W_sr");
  expect_drawn(script, "lwir", "lwir_emitted_W_sr");
  free(script);
}

/* A band of Johnson's system is told and drawn in magnitudes relative to Vega, AB beside it; the
 * numbers are those of lightcurve.csv. */
static void test_magnitudes(void **state)
{
  (void)state;
  char line[200];
  double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
  static const char *const columns[] = {"V_mag_vega", "V_mag_ab"};
  command_copy_data("box.yaml");
  struct command c =
      command_run("run", "box.yaml", "--out", "v", "--set", "time.step_s=20", "--set",
                  "bands.V={filter: johnson_v, vega_magnitude: 0.03, bins: 4}", NULL);
  assert_int_equal(c.code, 0);
  struct table t = table_read("v/lightcurve.csv");
  for (size_t k = 0; k < t.nrow; k++)
    for (int i = 0; i < 2; i++) {
      if (table_text(&t, k, columns[i])[0] == '\0') continue;
      if (!(table_number(&t, k, "sunlit_fraction") > 1e-3)) continue;
      least[i] = fmin(least[i], table_number(&t, k, columns[i]));
      most[i] = fmax(most[i], table_number(&t, k, columns[i]));
    }
  assert_true(least[0] < most[0] && fabs(least[0] - least[1]) > 0.01);
  snprintf(line, sizeof line,
           "\n      magnitude in sunlight, without air, V (Vega): %.2f to %.2f; AB: %.2f to %.2f\n",
           least[0], most[0], least[1], most[1]);
  if (strstr(c.out, line) == NULL) fail_msg("no '%s' in\n%s", line, c.out);
  assert_non_null(strstr(c.out, "\n      magnitude in sunlight, without air, vis (AB): "));
  assert_null(strstr(c.out, "lwir (AB)"));
  command_release(&c);
  char *script = command_read("v/plots.gp"), *drawn = strstr(script, "'magnitude (Vega)'");
  snprintf(line, sizeof line, "using (x(1)):%zu with lines", 1 + table_column(&t, columns[0]));
  assert_non_null(drawn);
  assert_non_null(strstr(drawn, line));
  drawn = strstr(script, "'AB magnitude'");
  snprintf(line, sizeof line, "using (x(1)):%zu with lines", 1 + table_column(&t, "vis_mag_ab"));
  assert_non_null(drawn);
  assert_non_null(strstr(drawn, line));
  table_release(&t);
  free(script);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_mechanisms_named, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_pictures, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_magnitudes, command_enter, command_leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
