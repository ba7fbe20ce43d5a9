/* Any CSV. */
#include "base/core/csv.h"

#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/fuzz.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_core_csv *csv = NULL;
  char *text = malloc(size > 0 ? size : 1); /* exact: a read behind the end is seen */
  if (text == NULL) abort();
  if (size > 0) memcpy(text, data, size);
  bool good = um_fuzz_good(context, um_core_csv_parse(context, "fuzz.csv", text, size, &csv));
  free(text);
  if (!good) {
    if (csv != NULL) um_fuzz_finding("a table in spite of the failure");
    return;
  }
  int line = 0;
  for (size_t i = 0; i < um_core_csv_rows(csv); i++) {
    if (um_core_csv_line(csv, i) <= line) um_fuzz_finding("lines do not ascend");
    line = um_core_csv_line(csv, i);
    for (size_t j = 0; j < um_core_csv_columns(csv); j++) {
      double value;
      (void)strlen(um_core_csv_text(csv, i, j));
      if (um_fuzz_good(context, um_core_csv_number(context, csv, i, j, &value)))
        um_fuzz_finite(value, "a field");
    }
  }
  for (size_t j = 0; j < um_core_csv_columns(csv); j++)
    if (um_core_csv_find(csv, um_core_csv_header(csv, j)) != j)
      um_fuzz_finding("column %zu is not found by its name", j);
  um_core_csv_destroy(&csv);
}
