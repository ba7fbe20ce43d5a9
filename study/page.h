/* report.html: the page of a study. */
#ifndef UMBRA_STUDY_PAGE_H
#define UMBRA_STUDY_PAGE_H

#include "base/core/file.h"
#include "study/statistics.h"

/* Into a folder that is being written. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_study_write_page(struct um_context *context, const struct um_study_result *result,
                                   const struct um_study_statistics *statistics,
                                   struct um_core_folder *folder);

#endif
