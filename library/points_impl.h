/* Many points into a folder, as a batch task. Private to library/. */
#ifndef UMBRA_LIBRARY_POINTS_IMPL_H
#define UMBRA_LIBRARY_POINTS_IMPL_H

#include "base/batch/task.h"
#include "library/session_impl.h"

/* Fill folder, resume, workers and share of a task; *records, the folder of the task, is freed by
 * the caller. UM_ERR_INPUT: no folder, a share that there is not; UM_ERR_MEMORY. */
enum um_status um_library_points(struct um_context *context, const struct umbra_points *points,
                                 struct um_batch_task *task, char **records);

#endif
