/* Tables as others write them: any separator, a header line that may be a comment; and files that
 * become tables (foreign_kinds.def). */
#ifndef UMBRA_COMPARE_FOREIGN_TABLE_H
#define UMBRA_COMPARE_FOREIGN_TABLE_H

#include "base/core/csv.h"

/* Read a table with a header of any names: fields parted by commas, semicolons, tabs or blanks, as
 * the first line that is no comment has them. The header is that line or, where it holds a
 * number or a time, the last line of comment before it, if that has as many names. Lines keep their
 * numbers. Refused, beside what um_core_csv_read refuses: a table without a header. UM_ERR_IO,
 * UM_ERR_INPUT, UM_ERR_MEMORY; *out is NULL then. The caller destroys. */
enum um_status um_compare_foreign_table_read(struct um_context *context, const char *path,
                                             struct um_core_csv **out);

#endif
