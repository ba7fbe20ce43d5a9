/* A survey track of Mini-MegaTORTORA. */
#include "evidence/measurements/mmt.h"
#include "tests/fuzz/rows.h"

void um_fuzz_one(struct um_context *context, const uint8_t *data, size_t size)
{
  struct um_compare_measurements *rows = NULL;
  struct um_compare_mmt_point *points = NULL;
  const char *path = um_fuzz_file(0, data, size);
  if (um_fuzz_good(context, um_compare_mmt_read(context, path, &rows, &points)))
    rows_try(context, rows);
  else if (rows != NULL || points != NULL)
    um_fuzz_finding("rows in spite of the failure");
  um_core_free(context, points);
  um_compare_measurements_destroy(context, &rows);
}
