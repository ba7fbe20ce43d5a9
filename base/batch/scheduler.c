/* The queue by worker processes: handed out one point at a time, to whoever has none. */
#include "base/batch/scheduler_impl.h"

#include <stdio.h>

#define LOOK        0.05 /* longest wait between two looks at what else there is to do [s] */
#define LOOK_RANKS  2e-3 /* the same where ranks speak, too [s] */
#define DEATHS_MOST 2    /* of workers over one point */

struct scheduler {
  struct um_batch *batch;
  size_t next;   /* of the queue */
  size_t *again; /* [nagain] points whose worker died, to be handed out again */
  size_t nagain, answered;
  size_t unsaid; /* kept, not yet told */
};

static bool take(struct scheduler *scheduler, size_t *number)
{
  if (scheduler->nagain > 0)
    *number = scheduler->again[--scheduler->nagain];
  else if (scheduler->next < scheduler->batch->nqueue)
    *number = scheduler->batch->queue[scheduler->next++];
  else
    return false;
  return true;
}

static void count(struct scheduler *scheduler)
{
  scheduler->answered++;
  scheduler->unsaid++;
}

/* A worker died over this point: once more, then no more. */
static enum um_status died(struct um_context *context, struct scheduler *scheduler,
                           const struct um_workers_answer *answer)
{
  char reason[160];
  struct um_batch_index_point *point =
      um_batch_index_point(scheduler->batch->index, answer->number);
  if (++point->deaths < DEATHS_MOST) {
    um_core_log(context, UM_LOG_WARNING,
                "a process that computed a point died (%s); the point is handed out again",
                answer->reason);
    scheduler->again[scheduler->nagain++] = answer->number;
    return UM_OK;
  }
  count(scheduler);
  snprintf(reason, sizeof reason, "the process that computed it died, twice (%s)", answer->reason);
  return um_batch_keep(context, scheduler->batch, answer->number, NULL, reason, true);
}

static enum um_status answered(struct um_context *context, void *self,
                               const struct um_workers_answer *answer)
{
  struct scheduler *scheduler = self;
  if (answer->died) return died(context, scheduler, answer);
  if (answer->status != UM_OK && !um_batch_is_of_point(answer->status))
    return um_core_fail(context, answer->status, "%s", answer->reason);
  count(scheduler);
  return um_batch_keep(context, scheduler->batch, answer->number, answer->value, answer->reason,
                       answer->status == UM_ERR_LIBRARY);
}

static enum um_status work(struct um_context *context, struct scheduler *scheduler)
{
  struct um_batch *batch = scheduler->batch;
  size_t number;
  while (scheduler->answered < batch->nqueue) {
    while (um_workers_pool_idle(batch->pool) > 0 && take(scheduler, &number))
      um_workers_pool_give(batch->pool, number, um_batch_index_coordinate(batch->index, number));
    while (batch->ranks != NULL && um_batch_ranks_idle(batch->ranks) > 0 &&
           take(scheduler, &number))
      um_batch_ranks_give(batch->ranks, number, um_batch_index_coordinate(batch->index, number));
    UM_TRY(um_workers_pool_wait(context, batch->pool, batch->ranks == NULL ? LOOK : LOOK_RANKS,
                                answered, scheduler));
    if (batch->ranks != NULL)
      UM_TRY(um_batch_ranks_hear(context, batch->ranks, answered, scheduler));
    UM_TRY(um_batch_tell(context, batch, &scheduler->unsaid, scheduler->answered == batch->nqueue));
  }
  return UM_OK;
}

static void drop_records(void *self) { um_batch_records_drop(self); }

/* Workers first: a process with MPI is better not forked. */
static enum um_status meet(struct um_context *context, struct um_batch *batch)
{
  if (batch->pool == NULL)
    UM_TRY(um_workers_pool_create(context, &batch->task.work,
                                  batch->records == NULL ? NULL : drop_records, batch->records,
                                  &batch->pool));
  if (batch->several && batch->ranks == NULL)
    UM_TRY(um_batch_ranks_join(context, &batch->task, &batch->ranks));
  return UM_OK;
}

enum um_status um_batch_scheduler_run(struct um_context *context, struct um_batch *batch)
{
  enum um_status status = UM_OK;
  struct scheduler scheduler = {.batch = batch};
  UM_CHECK(um_core_allocate(context, batch->nqueue, sizeof *scheduler.again, &scheduler.again));
  UM_CHECK(meet(context, batch));
  UM_CHECK(work(context, &scheduler));
done:
  um_core_free(context, scheduler.again);
  /* workers that are at a point which nobody waits for: the next call forks others */
  if (status != UM_OK) um_workers_pool_destroy(context, &batch->pool);
  return status;
}

enum um_status um_batch_scheduler_serve(struct um_context *context, struct um_batch *batch)
{
  UM_TRY(meet(context, batch));
  return um_batch_ranks_serve(context, batch->ranks, batch->pool);
}

void um_batch_scheduler_end(struct um_context *context, struct um_batch *batch)
{
  um_workers_pool_destroy(context, &batch->pool);
  /* the others wait for a word even where there was nothing to do */
  if (batch->several && batch->rank == 0 && batch->ranks == NULL)
    (void)um_batch_ranks_join(context, &batch->task, &batch->ranks);
  um_batch_ranks_leave(context, &batch->ranks);
}
