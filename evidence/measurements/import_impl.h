/* What the files of the import share. Private to evidence/measurements/. */
#ifndef UMBRA_COMPARE_IMPORT_IMPL_H
#define UMBRA_COMPARE_IMPORT_IMPL_H

#include "base/core/csv.h"
#include "evidence/measurements/import.h"

/* A column by name; UM_ERR_INPUT with the nearest and all that there are. */
enum um_status um_compare_import_column(struct um_context *context, const struct um_core_csv *csv,
                                        const char *name, size_t *index);
/* May the quantity have this value, in its own unit? UM_ERR_INPUT with file, line and column. */
enum um_status um_compare_import_check(struct um_context *context, const struct um_core_csv *csv,
                                       size_t row, size_t column, enum um_compare_quantity quantity,
                                       double value);

#endif
