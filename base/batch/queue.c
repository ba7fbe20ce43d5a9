/* Answers of points: kept on record, and the queue as this process computes it alone. */
#include <time.h>

#include "base/batch/queue_impl.h"

#define SYNC_EVERY 0.2 /* shortest time between two syncs of the disk [s] */

bool um_batch_is_of_point(enum um_status status)
{
  return status == UM_ERR_REFUSED || status == UM_ERR_INPUT || status == UM_ERR_NUMERIC ||
         status == UM_ERR_LIBRARY;
}

enum um_status um_batch_keep(struct um_context *context, struct um_batch *batch, size_t number,
                             const double *value, const char *reason, bool lost)
{
  struct um_batch_index_point *point = um_batch_index_point(batch->index, number);
  if (lost) {
    UM_TRY(um_core_strdup(context, reason, &point->reason));
    point->state = UM_BATCH_LOST;
    batch->lost++;
    return UM_OK;
  }
  UM_TRY(um_batch_records_append(context, batch->records,
                                 um_batch_index_coordinate(batch->index, number), value, reason,
                                 &point->place));
  point->state = UM_BATCH_RECORD;
  batch->recorded++;
  return UM_OK;
}

static double seconds(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static enum um_status compute_one(struct um_context *context, struct um_batch *batch, size_t number,
                                  double *value)
{
  um_core_quiet_begin(context);
  enum um_status status = batch->task.work.compute(
      context, batch->task.work.user, um_batch_index_coordinate(batch->index, number), value);
  um_core_quiet_end(context);
  if (status == UM_OK) return um_batch_keep(context, batch, number, value, NULL, false);
  if (!um_batch_is_of_point(status)) return status;
  status = um_batch_keep(context, batch, number, NULL, um_core_message(context),
                         status == UM_ERR_LIBRARY);
  if (status == UM_OK) um_core_message_clear(context);
  return status;
}

enum um_status um_batch_sync(struct um_context *context, struct um_batch *batch, bool now,
                             bool *synced)
{
  double t = seconds();
  *synced = now || t - batch->synced >= SYNC_EVERY;
  if (!*synced) return UM_OK;
  batch->synced = t;
  return um_batch_records_sync(context, batch->records);
}

enum um_status um_batch_tell(struct um_context *context, struct um_batch *batch, size_t *unsaid,
                             bool last)
{
  bool synced;
  size_t steps = *unsaid;
  if (steps == 0) return um_core_progress_step(context, 0);
  UM_TRY(um_batch_sync(context, batch, last, &synced));
  if (synced) *unsaid = 0;
  return um_core_progress_step(context, synced ? steps : 0);
}

enum um_status um_batch_run_here(struct um_context *context, struct um_batch *batch)
{
  enum um_status status = UM_OK;
  double *value;
  size_t unsaid = 0;
  UM_TRY(um_core_allocate(context, batch->task.work.nvalue, sizeof *value, &value));
  for (size_t i = 0; i < batch->nqueue; i++) {
    UM_CHECK(compute_one(context, batch, batch->queue[i], value));
    unsaid++;
    UM_CHECK(um_batch_tell(context, batch, &unsaid, i + 1 == batch->nqueue));
  }
done:
  um_core_free(context, value);
  return status;
}
