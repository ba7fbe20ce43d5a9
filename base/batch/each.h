/* Tasks by number (base/workers/each.h) whose answers are kept on record: for work that asks the
 * same questions in the same order whenever it is done. */
#ifndef UMBRA_BATCH_EACH_H
#define UMBRA_BATCH_EACH_H

#include "base/batch/batch.h"
#include "base/workers/each.h"

/* A batch of such work is opened with this task; identity, folder and resume are the caller's. No
 * ranks serve it, and it is never run. */
struct um_batch_task um_batch_each_task(void);

/* um_workers_each as one stage of the batch, by the number of the call: `done` is told of tasks on
 * record first, the others are computed, and are on record before `done` is told. A task that
 * failed is not. What tasks call themselves is no stage: they are whole or not at all. batch NULL:
 * nothing is kept. Errors of um_workers_each, UM_ERR_IO. */
enum um_status um_batch_each(struct um_context *context, struct um_batch *batch,
                             const struct um_workers_each *each);

#endif
