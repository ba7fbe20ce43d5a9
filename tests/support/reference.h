/* Figures of others that tests assert: tests/reference/NAME.csv, each with its source at its top.
 * They are part of the repository; a missing or broken one fails the test. */
#ifndef UMBRA_TESTS_SUPPORT_REFERENCE_H
#define UMBRA_TESTS_SUPPORT_REFERENCE_H

#include <stdio.h>

#include "base/core/context.h"
#include "base/core/csv.h"
#include "tests/support/cmocka_all.h"

/* Open tests/reference/NAME.csv; the caller destroys it. */
static inline struct um_core_csv *reference_open(struct um_context *context, const char *name)
{
  char path[1024];
  struct um_core_csv *csv = NULL;
  snprintf(path, sizeof path, "%s/tests/reference/%s.csv", UMBRA_SOURCE_DIR, name);
  if (um_core_csv_read(context, path, &csv) != UM_OK) fail_msg("%s", um_core_message(context));
  return csv;
}

static inline size_t reference_column(struct um_context *context, const struct um_core_csv *csv,
                                      const char *name)
{
  size_t column = 0;
  if (um_core_csv_require(context, csv, name, &column) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return column;
}

static inline const char *reference_text(struct um_context *context, const struct um_core_csv *csv,
                                         size_t row, const char *name)
{
  return um_core_csv_text(csv, row, reference_column(context, csv, name));
}

static inline double reference_number(struct um_context *context, const struct um_core_csv *csv,
                                      size_t row, const char *name)
{
  double value = NAN;
  if (um_core_csv_number(context, csv, row, reference_column(context, csv, name), &value) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return value;
}

#endif
