/* What commands that compute many points have in common. */
#ifndef UMBRA_APP_BATCH_H
#define UMBRA_APP_BATCH_H

#include "app/app.h"
#include "base/batch/task.h"

/* Fill the part of a task that --workers, --share and --resume say. Progress is told in a pipe,
 * too, from then on. UM_ERR_INPUT. */
enum um_status um_app_batch_options(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_batch_task *task);

/* Where records of results in `out` lie: beside them. The caller frees *records. */
enum um_status um_app_batch_records(struct um_context *context, const char *out, char **records);

/* The exit code of work that came to its end: UM_APP_LOST, after a word on standard error, where
 * points are lost. records: their folder. */
int um_app_batch_end(size_t lost, const char *records);

#endif
