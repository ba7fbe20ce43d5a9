/* Private to base/batch/: the queue by worker processes. */
#ifndef UMBRA_BATCH_SCHEDULER_IMPL_H
#define UMBRA_BATCH_SCHEDULER_IMPL_H

#include "base/batch/queue_impl.h"

/* The queue by the workers of this machine, forked at the first call, and those of other ranks.
 * After an error other ranks may still be at points: the batch is to be closed then. */
enum um_status um_batch_scheduler_run(struct um_context *context, struct um_batch *batch);
/* What rank 0 hands out, by the workers of this machine. */
enum um_status um_batch_scheduler_serve(struct um_context *context, struct um_batch *batch);
/* Ends the workers, and rank 0 the service of the others. */
void um_batch_scheduler_end(struct um_context *context, struct um_batch *batch);

#endif
