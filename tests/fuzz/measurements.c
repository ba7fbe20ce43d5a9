/* A CSV of measurements. */
#include "tests/fuzz/rows.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_compare_measurements *rows = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_compare_measurements_read(context, path, &rows)))
    rows_try(context, rows);
  else if (rows != NULL)
    um_fuzz_finding("rows in spite of the failure");
  um_compare_measurements_destroy(context, &rows);
}
