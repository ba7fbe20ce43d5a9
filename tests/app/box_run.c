/* Runs that several tests look at. */
#include "tests/app/box_run.h"

#include <stdio.h>

static int enter_run(void **state, const char *scenario)
{
  if (command_enter(state) != 0) return -1;
  command_copy_data(scenario);
  command_expect(0, "run", scenario, "--no-plots", "--out", "out", NULL);
  return 0;
}
int enter_box(void **state) { return enter_run(state, "box.yaml"); }
int enter_two_parts(void **state) { return enter_run(state, "two_parts.yaml"); }

const char *band_text(const struct table *t, size_t row, const char *band, const char *what)
{
  char column[64];
  snprintf(column, sizeof column, "%s_%s", band, what);
  return table_text(t, row, column);
}

double band_number(const struct table *t, size_t row, const char *band, const char *what)
{
  char column[64];
  snprintf(column, sizeof column, "%s_%s", band, what);
  return table_number(t, row, column);
}
