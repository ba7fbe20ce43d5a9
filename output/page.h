/* report.html: the page of a run. */
#ifndef UMBRA_OUTPUT_PAGE_H
#define UMBRA_OUTPUT_PAGE_H

#include "output/output.h"

/* Write report.html into the folder of a run in the making, whose pictures, if any, lie there
 * already. Radiances of surfaces are computed, at up to 60 instants. UM_ERR_MEMORY, UM_ERR_LIBRARY,
 * UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_output_write_page(struct um_context *context, const struct um_output_run *run,
                                    struct um_core_folder *folder);

#endif
