/* heat.csv holds what owns its nodes, so that its rows add up to the satellite: power is what was
 * put in, what one node gives another takes. */
#include <stdlib.h>

#include "output/output.h"
#include "tests/effects/heat_help.h"

#define TEXT    65536
#define COLUMNS 8

static void rows_add_up_to_the_satellite(void **state)
{
  (void)state;
  static const char *const node[] = {"panel", "bus", "bus.wall", "bus.interior"};
  struct heat_run run = heat_compute(LIST("parts.bus.interior.power_W=20"), NONE, NONE);
  const struct um_output_run out = {
      .model = run.model, .precomputed = run.precomputed, .result = run.result};
  char *text = calloc(TEXT, 1), *rest;
  double sum[COLUMNS] = {0}, gross[COLUMNS] = {0};
  bool seen[4] = {false};
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
    while (known < 4 && strcmp(at + 1, node[known]) != 0) known++;
    if (known == 4) fail_msg("a row of '%s'", at + 1);
    assert_false(seen[known]);
    seen[known] = true;
    for (size_t c = 0; c < COLUMNS; c++) {
      double value = strtod(end + 1, &end);
      sum[c] += value;
      gross[c] += fabs(value);
    }
  }
  for (size_t i = 0; i < 4; i++)
    if (!seen[i]) fail_msg("no row of '%s'", node[i]);
  /* solar, albedo, planet, internal, conducted, radiated, exchanged, stored; nine digits each */
  assert_true(fabs(sum[3] - 20.0) <= 1e-7);
  assert_true(gross[4] > 1.0 && fabs(sum[4]) <= 1e-8 * gross[4]);
  assert_true(gross[6] > 1.0 && fabs(sum[6]) <= 1e-8 * gross[6]);
  free(text);
  heat_release(&run);
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
  const struct CMUnitTest tests[] = {cmocka_unit_test(rows_add_up_to_the_satellite)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
