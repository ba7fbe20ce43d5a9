/* Private to base/batch/: a batch, its queue, and how an answer is kept. */
#ifndef UMBRA_BATCH_QUEUE_IMPL_H
#define UMBRA_BATCH_QUEUE_IMPL_H

#include "base/batch/index_impl.h"
#include "base/batch/ranks_impl.h"
#include "base/workers/pool.h"

struct um_batch {
  struct um_batch_task task; /* its folder is a copy */
  char *folder;
  struct um_batch_records *records; /* NULL where this process does not lead */
  struct um_batch_index *index;
  size_t recorded, lost; /* points on record, and those that were to be and are not */
  size_t *queue;         /* [nqueue] numbers of points to be computed, in the order asked */
  size_t nqueue;
  size_t stage;                 /* of um_batch_each: the next one's number */
  bool in_stage;                /* this process, or the one that forked it, is in one */
  double synced;                /* when the disk was last waited for [s] */
  struct um_workers_pool *pool; /* NULL: not needed yet */
  bool several;                 /* this process is one of several ranks */
  size_t rank;
  struct um_batch_ranks *ranks; /* NULL: not met yet */
};

/* Does a failure with this status concern its point alone? */
bool um_batch_is_of_point(enum um_status status);

/* Answer of a point: values, or the reason that makes it fail. LIBRARY and a dead worker are not
 * put on record (`lost`): the next process tries again. */
enum um_status um_batch_keep(struct um_context *context, struct um_batch *batch, size_t number,
                             const double *value, const char *reason, bool lost);

/* Bring records to the disk, where some time has passed since the last one or `now`; *synced: it
 * was done. UM_ERR_IO. */
enum um_status um_batch_sync(struct um_context *context, struct um_batch *batch, bool now,
                             bool *synced);
/* Points that were kept, *unsaid of them not yet told, count as done once they are on the disk.
 * Tell the progress, after a sync. Hears a stop. UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_batch_tell(struct um_context *context, struct um_batch *batch, size_t *unsaid,
                             bool last);

/* The queue by this process itself. */
enum um_status um_batch_run_here(struct um_context *context, struct um_batch *batch);

#endif
