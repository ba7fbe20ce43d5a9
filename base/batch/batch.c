/* A batch: what is asked is looked up on record, the rest is computed, the answers are put in
 * order. */
#include "base/batch/batch.h"

#include <math.h>
#include <stdio.h>

#include "base/batch/scheduler_impl.h"
#include "base/core/suggestions.h"

#define NAMED_MOST 10 /* points by their numbers in one message */

static enum um_status note_record(struct um_context *context, void *self, const double *coordinate,
                                  struct um_batch_place place)
{
  struct um_batch *batch = self;
  size_t number;
  UM_TRY(um_batch_index_number(context, batch->index, coordinate, &number));
  struct um_batch_index_point *point = um_batch_index_point(batch->index, number);
  if (point->state != UM_BATCH_RECORD) batch->recorded++;
  point->state = UM_BATCH_RECORD;
  point->place = place;
  point->foreign = true;
  return UM_OK;
}

enum um_status um_batch_open(struct um_context *context, const struct um_batch_task *task,
                             struct um_batch **out)
{
  enum um_status status;
  struct um_batch *batch;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *batch, &batch));
  batch->task = *task;
  UM_CHECK(um_core_strdup(context, task->folder, &batch->folder));
  batch->task.folder = batch->folder;
  if (!task->alone) UM_CHECK(um_batch_ranks_look(context, &batch->several, &batch->rank));
  UM_CHECK(um_batch_index_create(context, task->work.ncoordinate, &batch->index));
  if (um_batch_leads(batch))
    UM_CHECK(um_batch_records_open(context, &batch->task, note_record, batch, &batch->records));
  *out = batch;
  batch = NULL;
done:
  um_batch_close(context, &batch);
  return status;
}

size_t um_batch_recorded(const struct um_batch *batch) { return batch->recorded; }

bool um_batch_leads(const struct um_batch *batch) { return batch->rank == 0; }

enum um_status um_batch_serve(struct um_context *context, struct um_batch *batch)
{
  if (!um_batch_leads(batch)) return um_batch_scheduler_serve(context, batch);
  return um_core_fail(context, UM_ERR_INPUT, "this process leads its batch, and serves none");
}

/* A record that holds what is no point's values is none, and is said to be. */
static enum um_status check_record(struct um_context *context, struct um_batch *batch,
                                   size_t number, double *value, size_t *refused)
{
  struct um_batch_index_point *point = um_batch_index_point(batch->index, number);
  if (batch->task.accepts == NULL || !point->foreign || point->place.reason > 0) return UM_OK;
  point->foreign = false;
  UM_TRY(um_batch_records_value(context, batch->records, point->place, value));
  if (batch->task.accepts(batch->task.work.user, um_batch_index_coordinate(batch->index, number),
                          value))
    return UM_OK;
  point->state = UM_BATCH_NEW;
  batch->recorded--;
  (*refused)++;
  return UM_OK;
}

static enum um_status check_records(struct um_context *context, struct um_batch *batch,
                                    const size_t *number, size_t n)
{
  enum um_status status = UM_OK;
  size_t refused = 0;
  double *value;
  UM_TRY(um_core_allocate(context, batch->task.work.nvalue, sizeof *value, &value));
  for (size_t i = 0; i < n; i++) UM_CHECK(check_record(context, batch, number[i], value, &refused));
  if (refused > 0)
    um_core_log(context, UM_LOG_WARNING,
                "%s: %zu points on record hold values that no computation gives, and are computed "
                "anew",
                batch->folder, refused);
done:
  um_core_free(context, value);
  return status;
}

/* number [n]: which point is asked in each place; the queue: those that are to be computed. */
static enum um_status look_up(struct um_context *context, struct um_batch *batch,
                              const double *coordinate, size_t n, size_t *number)
{
  batch->nqueue = 0;
  for (size_t i = 0; i < n; i++)
    UM_TRY(um_batch_index_number(context, batch->index,
                                 coordinate + i * batch->task.work.ncoordinate, &number[i]));
  UM_TRY(check_records(context, batch, number, n));
  for (size_t i = 0; i < n; i++) {
    struct um_batch_index_point *point = um_batch_index_point(batch->index, number[i]);
    if (point->state != UM_BATCH_NEW) continue;
    if (batch->task.nshare > 1 && i % batch->task.nshare != batch->task.share) continue;
    point->state = UM_BATCH_WANTED;
    batch->queue[batch->nqueue++] = number[i];
  }
  return UM_OK;
}

/* After work that ended early: what was not reached may be asked again. */
static void forget_queue(struct um_batch *batch)
{
  for (size_t i = 0; i < batch->nqueue; i++) {
    struct um_batch_index_point *point = um_batch_index_point(batch->index, batch->queue[i]);
    if (point->state == UM_BATCH_WANTED) point->state = UM_BATCH_NEW;
  }
  batch->nqueue = 0;
}

static enum um_status work(struct um_context *context, struct um_batch *batch)
{
  um_core_progress_begin(context, "computing points", batch->nqueue);
  enum um_status status = batch->task.work.workers > 1 || batch->several
                              ? um_batch_scheduler_run(context, batch)
                              : um_batch_run_here(context, batch);
  um_core_progress_end(context);
  if (status != UM_OK)
    um_core_message_prefix(context, "%s: %zu points are on record", batch->folder, batch->recorded);
  return status;
}

static enum um_status answer(struct um_context *context, struct um_batch *batch, size_t number,
                             double *value, char **reason)
{
  const struct um_batch_index_point *point = um_batch_index_point(batch->index, number);
  if (point->state == UM_BATCH_RECORD && point->place.reason == 0)
    return um_batch_records_value(context, batch->records, point->place, value);
  for (size_t k = 0; k < batch->task.work.nvalue; k++) value[k] = NAN;
  if (point->state == UM_BATCH_RECORD)
    return um_batch_records_reason(context, batch->records, point->place, reason);
  return um_core_strdup(
      context, point->state == UM_BATCH_LOST ? point->reason : "is of another share", reason);
}

enum um_status um_batch_run(struct um_context *context, struct um_batch *batch,
                            const double *coordinate, size_t n, double *value, char **reason)
{
  enum um_status status;
  size_t *number = NULL;
  for (size_t i = 0; i < n; i++) reason[i] = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *number, &number));
  UM_CHECK(um_core_allocate(context, n, sizeof *batch->queue, &batch->queue));
  UM_CHECK(look_up(context, batch, coordinate, n, number));
  if (batch->nqueue > 0) UM_CHECK(work(context, batch));
  for (size_t i = 0; i < n; i++)
    UM_CHECK(answer(context, batch, number[i], value + i * batch->task.work.nvalue, &reason[i]));
done:
  forget_queue(batch);
  um_core_free(context, batch->queue);
  batch->queue = NULL;
  um_core_free(context, number);
  for (size_t i = 0; status != UM_OK && i < n; i++) {
    um_core_free(context, reason[i]);
    reason[i] = NULL;
  }
  return status;
}

size_t um_batch_lost(const struct um_batch *batch) { return batch->lost; }

void um_batch_tell_lost(struct um_context *context, struct um_batch *batch,
                        const double *coordinate, size_t n, const char *what, size_t first)
{
  char list[256] = "", more[40] = "", *reason = NULL;
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    size_t number =
        um_batch_index_find(batch->index, coordinate + i * batch->task.work.ncoordinate);
    const struct um_batch_index_point *point =
        number == SIZE_MAX ? NULL : um_batch_index_point(batch->index, number);
    char name[24];
    if (point == NULL || point->state != UM_BATCH_LOST) continue;
    if (count == 0) reason = point->reason;
    if (count++ >= NAMED_MOST) continue;
    snprintf(name, sizeof name, "%zu", first + i);
    um_core_words_append(list, sizeof list, name);
  }
  if (count == 0) return;
  if (count > NAMED_MOST) snprintf(more, sizeof more, " and %zu more", count - NAMED_MOST);
  um_core_log(context, UM_LOG_WARNING, "%s %s%s: not on record: %s", what, list, more, reason);
}

void um_batch_close(struct um_context *context, struct um_batch **batch)
{
  if (batch == NULL || *batch == NULL) return;
  um_batch_scheduler_end(context, *batch);
  um_batch_records_close(context, &(*batch)->records);
  um_batch_index_destroy(context, &(*batch)->index);
  um_core_free(context, (*batch)->queue);
  um_core_free(context, (*batch)->folder);
  um_core_free(context, *batch);
  *batch = NULL;
}
