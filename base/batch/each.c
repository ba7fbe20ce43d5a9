/* A stage: the answer of a task is cut into parts of one size, each a point of the batch with
 * stage, task and part for coordinates. A task is on record where all its parts are. */
#include "base/batch/each.h"

#include <string.h>

#include "base/batch/queue_impl.h"

#define PART 128 /* values of a record */

struct work {
  const struct um_workers_each *each;
  struct um_batch *batch;
  double stage;
  size_t *left; /* tasks that are not on record */
  double part[PART];
};

struct um_batch_task um_batch_each_task(void)
{
  return (struct um_batch_task){.work = {.ncoordinate = 5, .nvalue = PART}, .alone = true};
}

/* How many tasks of how many values there are stands in it, too: a stage that asks for something
 * else finds nothing. */
struct coordinates {
  double is[5];
};
static struct coordinates coordinates(const struct work *work, size_t which, size_t at)
{
  return (struct coordinates){
      {work->stage, (double)which, (double)at, (double)work->each->n, (double)work->each->nvalue}};
}

/* value [nvalue]; *found: the task is on record. */
static enum um_status recall(struct um_context *context, struct work *work, size_t which,
                             double *value, bool *found)
{
  size_t n = work->each->nvalue;
  for (size_t at = 0; at < n; at += PART) {
    const struct coordinates of = coordinates(work, which, at);
    size_t number = um_batch_index_find(work->batch->index, of.is);
    const struct um_batch_index_point *point =
        number == SIZE_MAX ? NULL : um_batch_index_point(work->batch->index, number);
    *found = point != NULL && point->state == UM_BATCH_RECORD && point->place.reason == 0;
    if (!*found) return UM_OK;
    UM_TRY(um_batch_records_value(context, work->batch->records, point->place, work->part));
    memcpy(value + at, work->part, (n - at < PART ? n - at : PART) * sizeof *value);
  }
  return UM_OK;
}

static enum um_status keep(struct um_context *context, struct work *work, size_t which,
                           const double *value)
{
  size_t n = work->each->nvalue, number;
  bool synced;
  for (size_t at = 0; at < n; at += PART) {
    const struct coordinates of = coordinates(work, which, at);
    memset(work->part, 0, sizeof work->part);
    memcpy(work->part, value + at, (n - at < PART ? n - at : PART) * sizeof *value);
    UM_TRY(um_batch_index_number(context, work->batch->index, of.is, &number));
    UM_TRY(um_batch_keep(context, work->batch, number, work->part, NULL, false));
  }
  return um_batch_sync(context, work->batch, false, &synced);
}

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct work *work = user;
  return work->each->compute(context, work->each->user, work->left[which], value);
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  struct work *work = user;
  if (status == UM_OK) UM_TRY(keep(context, work, work->left[which], value));
  return work->each->done(context, work->each->user, work->left[which], status, value);
}

/* Tell of the tasks on record; *nleft: the others. */
static enum um_status recall_all(struct um_context *context, struct work *work, size_t *nleft)
{
  enum um_status status = UM_OK;
  double *value = NULL;
  *nleft = 0;
  UM_TRY(um_core_allocate(context, work->each->nvalue, sizeof *value, &value));
  for (size_t i = 0; i < work->each->n; i++) {
    bool found = false;
    UM_CHECK(recall(context, work, i, value, &found));
    if (!found) {
      work->left[(*nleft)++] = i;
      continue;
    }
    UM_CHECK(work->each->done(context, work->each->user, i, UM_OK, value));
    UM_CHECK(um_core_progress_step(context, 1));
  }
done:
  um_core_free(context, value);
  return status;
}

static void drop_records(void *self) { um_batch_records_drop(self); }

enum um_status um_batch_each(struct um_context *context, struct um_batch *batch,
                             const struct um_workers_each *each)
{
  enum um_status status;
  if (batch == NULL || batch->in_stage) return um_workers_each(context, each);
  struct work work = {.each = each, .batch = batch, .stage = (double)batch->stage++};
  struct um_workers_each left = *each;
  batch->in_stage = true;
  UM_CHECK(um_core_allocate(context, each->n, sizeof *work.left, &work.left));
  UM_CHECK(recall_all(context, &work, &left.n));
  left.compute = compute;
  left.done = done;
  left.user = &work;
  left.before = drop_records;
  left.before_self = batch->records;
  UM_CHECK(um_workers_each(context, &left));
done:
  batch->in_stage = false;
  um_core_free(context, work.left);
  return status;
}
