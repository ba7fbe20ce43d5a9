/* report.html: the page of a comparison. */
#ifndef UMBRA_COMPARE_PAGE_H
#define UMBRA_COMPARE_PAGE_H

#include "base/core/file.h"
#include "evidence/comparison/comparison.h"

/* Write it into a folder in the making, whose pictures, if any, lie there already. command: for
 * the record. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_compare_write_page(struct um_context *context,
                                     const struct um_compare_comparison *comparison,
                                     const char *command, struct um_core_folder *folder);

#endif
