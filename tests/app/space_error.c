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

/* Off: the log says how to get it. */
static void test_how(void **state)
{
  (void)state;
  command_copy_data("box.yaml");
  command_expect(0, "run", "box.yaml", "--no-plots", "--out", "out", NULL);
  char *log = command_read("out/log.txt");
  assert_non_null(strstr(log, "error in space: not estimated; thermal.error_estimate: true"));
  free(log);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_said_and_found, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_how, command_enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
