/* A comparison in files. */
#ifndef UMBRA_COMPARE_REPORT_H
#define UMBRA_COMPARE_REPORT_H

#include <stdio.h>

#include "base/core/file.h"
#include "evidence/comparison/comparison.h"

/* compare.json, metrics.csv, residuals.csv and report.html into a folder in the making, with
 * `pictures` those of um_compare_plot; docs/files.md tells what stands in them. command and
 * version: for the record. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_compare_write(struct um_context *context,
                                const struct um_compare_comparison *comparison, const char *command,
                                const char *version, bool pictures, struct um_core_folder *folder);
/* compare.json to a stream; the caller looks for its errors. */
void um_compare_write_json(const struct um_compare_comparison *comparison, const char *command,
                           const char *version, FILE *file);

#endif
