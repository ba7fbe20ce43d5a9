/* Files that become a table before they are read as one: a file here and a line of
 * foreign_kinds.def each. */
#ifndef UMBRA_COMPARE_FOREIGN_KIND_H
#define UMBRA_COMPARE_FOREIGN_KIND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/core/context.h"

struct um_compare_foreign_kind {
  bool (*is)(const char *bytes, size_t length);
  /* Writes CSV with a header; its lines are those of the file where that has lines. UM_ERR_INPUT
   * with file and line. */
  enum um_status (*convert)(struct um_context *context, const char *path, const char *bytes,
                            size_t length, FILE *csv);
};

#define UM_FOREIGN_KIND(name) extern const struct um_compare_foreign_kind um_compare_foreign_##name;
#include "evidence/measurements/foreign_kinds.def"
#undef UM_FOREIGN_KIND

#endif
