/* thermal.error_estimate: what the log says is what the tables of two runs say. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"
#include "tests/app/table.h"

/* Largest and mean difference of the columns that end so, over all rows; relative: of the first. */
static void difference(const char *end, bool relative, const char *file, double *largest,
                       double *mean)
{
  char path[2][64];
  snprintf(path[0], sizeof path[0], "out/%s", file);
  snprintf(path[1], sizeof path[1], "fine/%s", file);
  struct table a = table_read(path[0]), b = table_read(path[1]);
  double n = 0.0;
  assert_int_equal(a.nrow, b.nrow);
  *largest = *mean = 0.0;
  for (size_t c = 0; c < a.ncolumn; c++) {
    size_t length = strlen(a.field[c]);
    if (length < strlen(end) || strcmp(a.field[c] + length - strlen(end), end) != 0) continue;
    for (size_t k = 0; k < a.nrow; k++, n += 1.0) {
      double was = table_number(&a, k, a.field[c]);
      double change = fabs(table_number(&b, k, a.field[c]) - was) / (relative ? was : 1.0);
      *largest = fmax(*largest, change);
      *mean += change;
    }
  }
  assert_true(n > 0.0);
  *mean /= n;
  table_release(&a);
  table_release(&b);
}

/* Two digits are printed. */
static void expect(const char *what, double said, double found)
{
  print_message("%s: %g in the log, %g in the tables\n", what, said, found);
  assert_close(said, found, 0.051 * found);
}

/* The bus of 1 m in facets of 0.5 m is cut in three, edges of sqrt(2)/3; the panel of 2 m x 1 m is
 * two facets, edges of sqrt(5). The second run states half of either. */
static void test_said_and_found(void **state)
{
  (void)state;
  double largest, mean, light, light_mean, found[2];
  unsigned fine, coarse;
  command_copy_data("two_parts.yaml");
  command_expect(0, "run", "two_parts.yaml", "--no-plots", "--out", "out", "--set",
                 "thermal.error_estimate=true", NULL);
  command_expect(0, "run", "two_parts.yaml", "--no-plots", "--out", "fine", "--set",
                 "parts.bus.facet_size_m=0.23570226063", "--set",
                 "parts.panel.facet_size_m=1.11803398986", NULL);
  char *log = command_read("out/log.txt"), *at = strstr(log, "error in space: ");
  assert_non_null(at);
  print_message("%.*s\n", (int)strcspn(at, "\n"), at);
  assert_int_equal(sscanf(at,
                          "error in space: %u surfaces in place of %u change temperatures of "
                          "places by %lg K at most (%*[^)]), %lg K in the mean; lwir by %lg %% at "
                          "most, %lg %% in the mean",
                          &fine, &coarse, &largest, &mean, &light, &light_mean),
                   6);
  assert_true(fine > 3 * coarse);
  difference(".mean_K", false, "temperatures.csv", &found[0], &found[1]);
  assert_true(found[0] > 1e-3);
  expect("largest [K]", largest, found[0]);
  expect("mean [K]", mean, found[1]);
  difference("lwir_intensity_W_sr", true, "lightcurve.csv", &found[0], &found[1]);
  expect("LWIR, largest [%]", light, 100.0 * found[0]);
  expect("LWIR, mean [%]", light_mean, 100.0 * found[1]);
  free(log);
}

static double number_after(const char *text, const char *before)
{
  const char *at = strstr(text, before);
  assert_non_null(at);
  return strtod(at + strlen(before), NULL);
}

/* A flat box of 25 kg/m2 whose walls meet at their rims: what a run says of its facets is what much
 * finer ones change, and facets made for it leave as little as was asked for. The wall conducts
 * over sqrt(0.5 / (4 eps sigma T^3)) = 0.4 m, so that facets of 1 m blur the rims. An estimate that
 * is within a quarter says whether to refine. */
static void test_finer_facets(void **state)
{
  (void)state;
  double largest, mean;
  command_copy_data("slab.yaml");
  struct command c = command_run("run", "slab.yaml", "--no-plots", "--out", "out", "--json", NULL);
  assert_int_equal(c.code, 0);
  char *log = command_read("out/log.txt");
  double said = number_after(log, "mesh: finer facets would move temperatures of places by about ");
  double lwir = number_after(log, "lwir by about ");
  free(log);
  assert_close(number_after(c.out, "\"place_K\": "), said, 0.051 * fabs(said));
  char *band = strstr(c.out, "\"name\": \"lwir\"");
  assert_non_null(band);
  assert_close(100.0 * number_after(band, "\"finer_facets_largest\": "), lwir, 0.051 * fabs(lwir));
  command_release(&c);
  command_expect(0, "run", "slab.yaml", "--no-plots", "--out", "fine", "--set",
                 "thermal.facet_size_m=0.1", NULL);
  difference("mean_K", false, "temperatures.csv", &largest, &mean);
  print_message("said %+.3g K, found %.3g K\n", said, largest);
  assert_true(largest > 2.0);
  assert_close(fabs(said), largest, 0.25 * largest);
  difference("lwir_intensity_W_sr", true, "lightcurve.csv", &largest, &mean);
  print_message("said %+.3g %%, found %.3g %%\n", lwir, 100.0 * largest);
  assert_close(fabs(lwir), 100.0 * largest, 25.0 * largest);

  c = command_run("export", "slab.yaml", "--as", "facets", "-o", "facets.csv", "--json", "--set",
                  "thermal.facet_error_K=0.5", NULL);
  assert_int_equal(c.code, 0);
  print_message("%s", c.out);
  assert_non_null(strstr(c.out, "\"reached\": true"));
  size_t facets = 0; /* of the last round: the least that are off come last */
  for (const char *at = c.out; (at = strstr(at, "\"facets\": ")) != NULL; at++)
    facets = (size_t)strtoul(at + strlen("\"facets\": "), NULL, 10);
  assert_true(facets > 500 && facets < 1600);
  command_release(&c);
  command_expect(0, "run", "slab.yaml", "--no-plots", "--force", "--out", "out", "--set",
                 "thermal.facets=facets.csv", NULL);
  difference("mean_K", false, "temperatures.csv", &largest, &mean);
  print_message("left %.3g K\n", largest);
  assert_true(largest < 0.6);
}

/* thermal.error_estimate halves all facets once more that a file has cut. Slivers at the rims
 * become two, others four. */
static void test_cut_and_halved(void **state)
{
  (void)state;
  unsigned fine, coarse;
  double largest, mean, said;
  command_copy_data("slab.yaml");
  command_write("facets.csv", "round,part,facets,facet\n1,slab,80,3\n");
  command_expect(0, "run", "slab.yaml", "--no-plots", "--out", "out", "--set",
                 "thermal.facets=facets.csv", "--set", "thermal.error_estimate=true", NULL);
  char *log = command_read("out/log.txt"), *at = strstr(log, "error in space: ");
  assert_non_null(at);
  print_message("%.*s\n", (int)strcspn(at, "\n"), at);
  assert_int_equal(sscanf(at,
                          "error in space: %u surfaces in place of %u change temperatures of "
                          "places by %lg K",
                          &fine, &coarse, &said),
                   3);
  free(log);
  assert_true(coarse > 80 && coarse < 100);
  assert_true(fine > 3 * coarse);
  command_expect(0, "run", "slab.yaml", "--no-plots", "--out", "fine", "--set",
                 "thermal.facet_size_m=0.5", NULL);
  difference("mean_K", false, "temperatures.csv", &largest, &mean);
  print_message("said %.3g K, facets of half the size %.3g K\n", said, largest);
  assert_close(said, largest, 0.1 * largest);
}

/* Halvings that do not fit are refused, each with its line. */
static void test_refused(void **state)
{
  (void)state;
  static const char *const cases[][2] = {
      {"1,wing,40,3\n", "facets.csv:2: column 'part': 'wing' is not a part; accepted: slab"},
      {"0,slab,40,3\n", "facets.csv:2: column 'round': 0; accepted: a whole number, 1 to 32"},
      {"1,slab,40,40\n", "facets.csv:2: column 'facet': 40; accepted: a whole number, 0 to 39"},
      {"1,slab,40,3\n1,slab,40,3\n", "facets.csv:3: column 'round': facet 3 of round 1"},
      {"1,slab,40,3\n3,slab,41,3\n", "facets.csv:3: column 'round': facet 3 of round 3"},
      {"1,slab,9999,3\n", "part 'slab': halvings are of 9999 facets, but it has"}};
  command_copy_data("slab.yaml");
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    char text[200];
    snprintf(text, sizeof text, "round,part,facets,facet\n%s", cases[i][0]);
    command_write("facets.csv", text);
    struct command c =
        command_run("check", "slab.yaml", "--set", "thermal.facets=facets.csv", NULL);
    assert_int_equal(c.code, 1);
    if (strstr(c.err, cases[i][1]) == NULL) fail_msg("%s", c.err);
    command_release(&c);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_said_and_found, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_finer_facets, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_cut_and_halved, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refused, command_enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
