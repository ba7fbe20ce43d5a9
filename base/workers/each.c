/* Tasks by number: handed out one at a time to whichever worker has none. */
#include "base/workers/each.h"

#include "base/workers/pool.h"

#define LOOK 0.05 /* longest wait between two looks for a stop [s] */

struct work {
  const struct um_workers_each *each;
  struct um_workers_pool *pool;
  size_t next, answered; /* tasks handed out a first time, and done */
  size_t *again;         /* [nagain] tasks whose worker died */
  size_t nagain;
  bool *died; /* [n] a worker did over this task */
};

static enum um_status compute(struct um_context *context, void *user, const double *coordinate,
                              double *value)
{
  const struct work *work = user;
  return work->each->compute(context, work->each->user, (size_t)coordinate[0], value);
}

static enum um_status died(struct um_context *context, struct work *work,
                           const struct um_workers_answer *answer)
{
  if (work->died[answer->number])
    return um_core_fail(context, UM_ERR_LIBRARY, "the process that computed it died, twice (%s)",
                        answer->reason);
  um_core_log(context, UM_LOG_WARNING,
              "a worker process died (%s); what it computed is computed again", answer->reason);
  work->died[answer->number] = true;
  work->again[work->nagain++] = answer->number;
  return UM_OK;
}

static enum um_status answered(struct um_context *context, void *self,
                               const struct um_workers_answer *answer)
{
  struct work *work = self;
  const struct um_workers_each *each = work->each;
  if (answer->died) return died(context, work, answer);
  work->answered++;
  if (answer->status != UM_OK) um_core_fail(context, answer->status, "%s", answer->reason);
  UM_TRY(each->done(context, each->user, answer->number, answer->status, answer->value));
  return um_core_progress_step(context, 1);
}

static enum um_status hand_out(struct um_context *context, struct work *work)
{
  while (work->answered < work->each->n) {
    while (um_workers_pool_idle(work->pool) > 0 &&
           (work->nagain > 0 || work->next < work->each->n)) {
      size_t which = work->nagain > 0 ? work->again[--work->nagain] : work->next++;
      um_workers_pool_give(work->pool, which, &(double){(double)which});
    }
    UM_TRY(um_workers_pool_wait(context, work->pool, LOOK, answered, work));
    UM_TRY(um_core_progress_step(context, 0)); /* hears a stop */
  }
  return UM_OK;
}

static enum um_status by_workers(struct um_context *context, const struct um_workers_each *each,
                                 int workers)
{
  enum um_status status;
  struct work work = {.each = each};
  const struct um_workers_task task = {.ncoordinate = 1,
                                       .nvalue = each->nvalue,
                                       .compute = compute,
                                       .user = &work,
                                       .workers = workers};
  UM_CHECK(um_core_allocate(context, each->n, sizeof *work.again, &work.again));
  UM_CHECK(um_core_allocate(context, each->n, sizeof *work.died, &work.died));
  UM_CHECK(um_workers_pool_create(context, &task, each->before, each->before_self, &work.pool));
  UM_CHECK(hand_out(context, &work));
done:
  um_workers_pool_destroy(context, &work.pool);
  um_core_free(context, work.died);
  um_core_free(context, work.again);
  return status;
}

static enum um_status here(struct um_context *context, const struct um_workers_each *each)
{
  enum um_status status = UM_OK;
  double *value;
  UM_TRY(um_core_allocate(context, each->nvalue, sizeof *value, &value));
  for (size_t i = 0; i < each->n; i++) {
    for (size_t k = 0; k < each->nvalue; k++) value[k] = 0.0;
    um_core_quiet_begin(context);
    status = each->compute(context, each->user, i, value);
    um_core_quiet_end(context);
    UM_CHECK(each->done(context, each->user, i, status, status == UM_OK ? value : NULL));
    UM_CHECK(um_core_progress_step(context, 1));
  }
done:
  um_core_free(context, value);
  return status;
}

enum um_status um_workers_each(struct um_context *context, const struct um_workers_each *each)
{
  size_t workers = each->workers > 1 ? (size_t)each->workers : 1;
  if (workers > each->n) workers = each->n;
  return workers > 1 ? by_workers(context, each, (int)workers) : here(context, each);
}
