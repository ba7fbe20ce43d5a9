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
/* The unit that the name of a column ends in, "C" of "T_C" or "panel (C)"; NULL: none of the
 * quantity. Does not fail. */
const char *um_compare_import_unit(const char *column, enum um_compare_quantity quantity);

/* What a row of several sensors is. */
enum um_compare_import_frame {
  UM_IMPORT_FRAME_GOOD,
  UM_IMPORT_FRAME_ZEROS, /* every sensor says 0: nothing was received */
  UM_IMPORT_FRAME_HELD   /* every sensor says what it said in the row before, beyond chance */
};
/* (*out)[rows] of columns [n], n above 1; the caller frees. import_frames.c. */
enum um_status um_compare_import_frames(struct um_context *context, const struct um_core_csv *csv,
                                        const size_t *column, size_t n,
                                        enum um_compare_import_frame **out);

#endif
