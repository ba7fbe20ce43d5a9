/* What comes to stand in a script: texts as string constants in which nothing means anything,
 * numbers that gnuplot knows, names of files that are names of files. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/plot/plot.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

static char folder[UM_TEST_PATH];
static struct um_context *context;
static struct um_plot *plot;

static int enter(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return -1;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  return um_plot_create(context, folder, "s.gp", &plot) == UM_OK ? 0 : -1;
}

static int leave(void **state)
{
  (void)state;
  um_plot_destroy(context, &plot);
  um_core_context_destroy(&context);
  char path[UM_TEST_PATH + 8];
  snprintf(path, sizeof path, "%s/s.gp", folder);
  remove(path);
  return um_test_folder_remove(folder);
}

/* The script so far, without pictures drawn; the caller frees. */
static char *script(void)
{
  char path[UM_TEST_PATH + 8], *text = calloc(1, 1 << 20);
  um_plot_destroy(context, &plot);
  snprintf(path, sizeof path, "%s/s.gp", folder);
  FILE *file = fopen(path, "rb");
  assert_non_null(file);
  assert_non_null(text);
  assert_true(fread(text, 1, (1 << 20) - 1, file) > 0);
  fclose(file);
  return text;
}

static void expect(const char *part)
{
  char *text = script();
  if (strstr(text, part) == NULL) fail_msg("no\n%s\nin\n%s", part, text);
  free(text);
}

static void test_texts(void **state)
{
  (void)state;
  static const struct {
    const char *given, *written;
  } cases[] = {
      {"box", "'box'"},
      {"", "''"},
      {"`touch x` $(y) \\ \"q\" @m {^_&~}", "'`touch x` $(y) \\ \"q\" @m {^_&~}'"},
      {"it's", "'it’s'"},
      {"'", "'’'"},
      {"''; system('x'); '", "'’’; system(’x’); ’'"},
      {"a\nb\rc\td\x7f", "'a b c d '"},
      {"EOD\nsystem", "'EOD system'"},
      {"µm σ χ² 太", "'µm σ χ² 太'"},
      {"\xff\xc3", "'?\?'"}, /* no UTF-8 */
      {"\xc0\xa7", "'?\?'"}, /* a quote, overlong */
      {"\xe2\x80\xae right to left", "'  right to left'"},
      {"\xc2\x85next line", "' next line'"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    um_plot_add(plot, "case %zu %s end\n", i, cases[i].given);
  char *text = script();
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char line[200];
    snprintf(line, sizeof line, "case %zu %s end\n", i, cases[i].written);
    if (strstr(text, line) == NULL) fail_msg("no %s in\n%s", line, text);
  }
  free(text);
}

/* No line of a script grows with a name. */
static void test_long_text(void **state)
{
  (void)state;
  char longest[100001];
  memset(longest, 'n', sizeof longest - 1);
  longest[sizeof longest - 1] = '\0';
  um_plot_add(plot, "%s\n", longest);
  um_plot_picture(plot, longest, 100, 100);
  char *text = script();
  assert_true(strlen(text) < 8000);
  assert_non_null(strstr(text, "n…'\n"));
  free(text);
}

static void test_numbers(void **state)
{
  (void)state;
  um_plot_add(plot, "[%d|%u|%zu|%.3f|%g|%e|%%|%5.1f]", -3, 4u, (size_t)5, 1.0 / 3.0, 2.5, 1000.0,
              0.25);
  um_plot_add(plot, "[%g|%.2f|%g]", NAN, INFINITY, -INFINITY);
  expect("[-3|4|5|0.333|2.5|1.000000e+03|%|  0.2][NaN|NaN|NaN]");
}

/* `set output '| command'` runs a command, a slash leads out of the folder. */
static void test_file_names(void **state)
{
  (void)state;
  static const char *const given[] = {"|touch x", "../../up", "-e", "a`b'c\"d$e\nf", "µ é", ""};
  static const char *const written[] = {"'_touch_x'.'.'.kind", "'_._.._up'.'.'.kind",
                                        "'_e'.'.'.kind",       "'a_b_c_d_e_f'.'.'.kind",
                                        "'µ_é'.'.'.kind",      "'_'.'.'.kind"};
  for (size_t i = 0; i < sizeof given / sizeof given[0]; i++)
    um_plot_picture(plot, given[i], 100, 100);
  char *text = script(), *at = text;
  for (size_t i = 0; i < sizeof written / sizeof written[0]; i++) {
    char line[80];
    snprintf(line, sizeof line, "set output %s\n", written[i]);
    at = strstr(at, "set output");
    assert_non_null(at);
    if (strncmp(at, line, strlen(line)) != 0) fail_msg("not %sbut %.60s", line, at);
    at++;
  }
  free(text);
}

static void test_units(void **state)
{
  (void)state;
  char unit[80];
  assert_close(um_plot_power(4.2e-11, "W/m^2", unit), 1e-11, 1e-26);
  assert_string_equal(unit, "10^{−11} W/m^2");
  assert_close(um_plot_power(1280.0, "W/sr", unit), 1.0, 0.0);
  assert_string_equal(unit, "W/sr");
  assert_close(um_plot_power(3e7, "W/sr", unit), 1e7, 0.0);
  assert_string_equal(unit, "10^{7} W/sr");
  assert_close(um_plot_power(NAN, "K", unit), 1.0, 0.0);
  assert_close(um_plot_power(0.0, "K", unit), 1.0, 0.0);
  assert_close(um_plot_spacing(4502.0), 1000.0, 1e-9);
  assert_close(um_plot_spacing(4.8), 1.0, 1e-12);
  assert_close(um_plot_spacing(30.0), 10.0, 1e-12);
  assert_close(um_plot_spacing(NAN), 1.0, 0.0);
  um_plot_unit("W/m^2/sr", unit);
  assert_string_equal(unit, "W/m²/sr");
}

/* Edges of the shadow lie halfway between what is lit and what is not. */
static void test_shade(void **state)
{
  (void)state;
  static const double t[] = {0.0, 60.0, 120.0, 180.0, 240.0};
  static const double sunlit[] = {1.0, 0.0, 0.0, 0.4, 1.0};
  struct um_plot_time time = um_plot_time(0.0, 240.0, "2020-01-01T00:00:00.000Z");
  assert_string_equal(time.word, "minutes");
  um_plot_picture(plot, "p", 100, 100);
  um_plot_shade(plot, &time, 5, t, sunlit);
  um_plot_time_label(plot, &time);
  char *text = script();
  assert_non_null(strstr(text, "from first 0.500000, graph 0 to first 2.500000, graph 1 fillcolor "
                               "rgb '#d8dce6'"));
  assert_non_null(strstr(text, "from first 2.500000, graph 0 to first 3.500000, graph 1 fillcolor "
                               "rgb '#eceef3'"));
  assert_null(strstr(text, "set object 3"));
  assert_non_null(strstr(text, "'minutes after 2020-01-01 00:00:00 UTC; grey: umbra, light grey: "
                               "penumbra'"));
  free(text);
  assert_string_equal(um_plot_time(0.0, 5.0 * 3600.0, "").word, "hours");
  assert_string_equal(um_plot_time(0.0, 5.0 * 86400.0, "").word, "days");
}

static struct um_plot_range range_of(const double *v, size_t n, const double *model, size_t nmodel,
                                     double anchor, double stretch)
{
  struct um_plot_range r;
  const struct um_plot_values set[] = {{v, n, UM_PLOT_MOST}, {model, nmodel, UM_PLOT_MIDDLE}};
  assert_int_equal(um_plot_range(context, set, 2, anchor, stretch, &r), UM_OK);
  return r;
}

/* An axis holds what most values need: a few that are far off, and a model that is dark at a few,
 * do not set it; those few are counted. Small sets are whole, and where a model is elsewhere both
 * are seen. */
static void test_range(void **state)
{
  (void)state;
  enum { N = 93 };
  double v[N], model[N];
  for (int i = 0; i < N; i++) v[i] = model[i] = 8.0 + 0.02 * i; /* 8 to 9.84 */
  struct um_plot_range r = range_of(v, N, model, N, NAN, UM_PLOT_STRETCH);
  assert_false(r.cut);
  assert_true(r.low < 8.0 && r.low > 7.8 && r.high > 9.84 && r.high < 10.0);
  v[3] = 21.5;
  v[40] = 19.0;
  v[90] = 23.25;
  for (int i = 0; i < 20; i++) model[i] = i % 2 == 0 ? 72.0 : INFINITY;
  model[21] = 11.0; /* within the length of the rest */
  r = range_of(v, N, model, N, NAN, UM_PLOT_STRETCH);
  assert_true(r.cut && r.below == 0 && r.above == 3);
  assert_close(r.highest, 23.25, 0.0);
  assert_true(r.high > 11.0 && r.high < 11.5);
  um_plot_picture(plot, "p", 100, 100);
  um_plot_ordinate(plot, &r, 0.5, true);
  /* a model 30 times the length of the measurements off is on the axis */
  for (int i = 0; i < N; i++) model[i] = 60.0;
  r = range_of(v, N, model, N, NAN, UM_PLOT_STRETCH);
  assert_true(r.low < 8.0 && r.high > 60.0);
  /* a peak of light is no outlier: below ten times the rest it is whole */
  for (int i = 0; i < N; i++) v[i] = model[i] = 2.0 + 0.01 * i;
  v[7] = 20.0;
  r = range_of(v, N, model, N, 0.0, UM_PLOT_STRETCH_LIGHT);
  assert_true(!r.cut && r.low < 0.0 && r.high > 20.0);
  v[7] = 2e5; /* a cosmic ray is one */
  r = range_of(v, N, model, N, 0.0, UM_PLOT_STRETCH_LIGHT);
  assert_true(r.above == 1 && r.high < 3.2);
  /* 4 values hold no outlier; constants and nothing have an axis */
  static const double four[] = {1.0, 1.1, 50.0, 1.2}, same[] = {3.0, 3.0, 3.0}, none[] = {NAN};
  r = range_of(four, 4, four, 4, NAN, UM_PLOT_STRETCH);
  assert_true(!r.cut && r.high > 50.0);
  r = range_of(same, 3, same, 3, NAN, UM_PLOT_STRETCH);
  assert_true(r.low < 3.0 && r.high > 3.0);
  r = range_of(none, 1, none, 1, NAN, UM_PLOT_STRETCH);
  assert_true(r.low < r.high && !r.cut && r.below + r.above == 0);
  char *text = script();
  const char *axis = strstr(text, "set yrange [");
  double from, to;
  assert_int_equal(sscanf(axis, "set yrange [%lf:%lf]", &from, &to), 2); /* magnitudes fall */
  assert_true(from > 22.0 && from < 23.0 && to < 16.0 && to > 15.0);
  assert_non_null(strstr(text, "'3 beyond the axis, to 46.5'"));
  free(text);
}

/* A curve stops where nothing is between two passes, and where there is no light. */
static void test_gaps(void **state)
{
  (void)state;
  static const double t[] = {0.0, 60.0, 120.0, 180.0, 5400.0, 5460.0, 9000.0, 9060.0, 9120.0};
  static const double value[] = {5.0, 5.5, INFINITY, 6.0, 7.0, 7.5, 8.0, NAN, NAN};
  struct um_plot_time time = um_plot_time(0.0, 9120.0, "2020-01-01T00:00:00.000Z");
  double gap;
  assert_int_equal(um_plot_gap(context, 9, t, &gap), UM_OK);
  assert_close(gap, 480.0, 1e-9);
  um_plot_curve(plot, &time, 7, 9, t, value, gap);
  expect("$curve7 << EOD\n0.000000000,5\n1.000000000,5.5\n\n3.000000000,6\n\n90.000000000,7\n"
         "91.000000000,7.5\n\n150.000000000,8\n\nEOD\n");
}

/* A full disk is an error of the run, a folder that is not there too. */
static void test_folder(void **state)
{
  (void)state;
  struct um_plot *other = NULL;
  assert_int_equal(um_plot_create(context, "/nowhere/at/all", "s.gp", &other), UM_ERR_IO);
  assert_null(other);
  assert_non_null(strstr(um_core_message(context), "/nowhere/at/all/s.gp"));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_texts, enter, leave),
      cmocka_unit_test_setup_teardown(test_long_text, enter, leave),
      cmocka_unit_test_setup_teardown(test_numbers, enter, leave),
      cmocka_unit_test_setup_teardown(test_file_names, enter, leave),
      cmocka_unit_test_setup_teardown(test_units, enter, leave),
      cmocka_unit_test_setup_teardown(test_shade, enter, leave),
      cmocka_unit_test_setup_teardown(test_range, enter, leave),
      cmocka_unit_test_setup_teardown(test_gaps, enter, leave),
      cmocka_unit_test_setup_teardown(test_folder, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
