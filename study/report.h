/* Statistics of a study, as tables and on the terminal. */
#ifndef UMBRA_STUDY_REPORT_H
#define UMBRA_STUDY_REPORT_H

#include <stdio.h>

#include "base/core/file.h"
#include "study/statistics.h"

/* Into a folder that is being written: summary.csv (spread of every quantity over the points),
 * curves.csv (quantiles of the curves), indices.csv (indices over time), limits.csv (where there
 * are limits), table.md (a table for a paper), report.html (study/page.h). docs/files.md says the
 * columns. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_study_report_write(struct um_context *context,
                                     const struct um_study_result *result,
                                     const struct um_study_statistics *statistics,
                                     struct um_core_folder *folder);

/* The limits of a result as limits.csv and as lines for a person; either may be NULL.
 * UM_ERR_MEMORY. */
enum um_status um_study_limits_write(struct um_context *context,
                                     const struct um_study_result *result, FILE *file, FILE *words);

/* The summary for a person: points, what failed and why, spread of each quantity, a sentence for
 * each curve. UM_ERR_MEMORY. */
enum um_status um_study_report_print(struct um_context *context,
                                     const struct um_study_result *result,
                                     const struct um_study_statistics *statistics, FILE *file);

#endif
