/* heat.csv holds what owns its nodes, so that its rows add up to the satellite: power is what was
 * put in, what one node gives another takes. */
#include <stdlib.h>

#include "output/output.h"
#include "tests/effects/heat_help.h"

#define TEXT    65536
#define COLUMNS 8

static void rows_add_up(const char *const *set, const char *const *with, size_t nnode)
{
  static const char *const node[] = {"panel", "bus", "bus.wall", "bus.interior", "bus.inside"};
  struct heat_run run = heat_compute(set, with, NONE);
  const struct um_output_run out = {
      .model = run.model, .precomputed = run.precomputed, .result = run.result};
  char *text = calloc(TEXT, 1), *rest;
  double sum[COLUMNS] = {0}, gross[COLUMNS] = {0};
  bool seen[5] = {false};
  FILE *file = tmpfile();
  assert_non_null(text);
  assert_non_null(file);
  assert_int_equal(um_output_write_heat(&out, file), UM_OK);
  rewind(file);
  assert_true(fread(text, 1, TEXT - 1, file) > 0);
  assert_int_equal(fclose(file), 0);
  char first[32] = "";
  strtok_r(text, "\n", &rest); /* the header */
  for (char *line; (line = strtok_r(NULL, "\n", &rest)) != NULL;) {
    char *at = strchr(line, ','), *end = strchr(at + 1, ',');
    size_t known = 0;
    if (first[0] == '\0') snprintf(first, sizeof first, "%.*s", (int)(at - line), line);
    if (strncmp(line, first, strlen(first)) != 0) break; /* of the first observation */
    *end = '\0';
    while (known < nnode && strcmp(at + 1, node[known]) != 0) known++;
    if (known == nnode) fail_msg("a row of '%s'", at + 1);
    assert_false(seen[known]);
    seen[known] = true;
    for (size_t c = 0; c < COLUMNS; c++) {
      double value = strtod(end + 1, &end);
      sum[c] += value;
      gross[c] += fabs(value);
    }
  }
  for (size_t i = 0; i < nnode; i++)
    if (!seen[i]) fail_msg("no row of '%s'", node[i]);
  /* solar, albedo, planet, internal, conducted, radiated, exchanged, stored; nine digits each */
  assert_true(fabs(sum[3] - 20.0) <= 1e-7);
  assert_true(gross[4] > 1.0 && fabs(sum[4]) <= 1e-8 * gross[4]);
  assert_true(gross[6] > 1.0 && fabs(sum[6]) <= 1e-8 * gross[6]);
  free(text);
  heat_release(&run);
}

static void rows_add_up_to_the_satellite(void **state)
{
  (void)state;
  rows_add_up(LIST("parts.bus.interior.power_W=20"), NONE, 4);
}

/* Inner layers have a row of their own. */
static void rows_of_an_inside(void **state)
{
  (void)state;
  rows_add_up(LIST("parts.bus.interior.power_W=20", "parts.bus.inside_emittance=0.8",
                   "parts.bus.shell.through_conductance_W_m2_K=30"),
              LIST("mutual_radiation"), 5);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("output_heat_table.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_add_up_to_the_satellite),
                                     cmocka_unit_test(rows_of_an_inside)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
