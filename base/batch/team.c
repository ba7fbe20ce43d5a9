/* The queue by worker processes: handed out one point at a time, to whoever has none. */
#include "base/batch/team_impl.h"

#include <stdio.h>

#define LOOK        0.05 /* longest wait between two looks at what else there is to do [s] */
#define LOOK_RANKS  2e-3 /* the same where ranks speak, too [s] */
#define DEATHS_MOST 2    /* of workers over one point */

struct team {
  struct um_batch *batch;
  size_t next;   /* of the queue */
  size_t *again; /* [nagain] points whose worker died, to be handed out again */
  size_t nagain, answered;
  struct um_batch_done done;
};

static bool take(struct team *team, size_t *number)
{
  if (team->nagain > 0)
    *number = team->again[--team->nagain];
  else if (team->next < team->batch->nqueue)
    *number = team->batch->queue[team->next++];
  else
    return false;
  return true;
}

static void count(struct team *team)
{
  team->answered++;
  team->done.unsaid++;
}

/* A worker died over this point: once more, then no more. */
static enum um_status died(struct um_context *context, struct team *team,
                           const struct um_batch_answer *answer)
{
  char reason[160];
  struct um_batch_known_point *point = um_batch_known_point(team->batch->known, answer->number);
  if (++point->deaths < DEATHS_MOST) {
    um_core_log(context, UM_LOG_WARNING,
                "a process that computed a point died (%s); the point is handed out again",
                answer->reason);
    team->again[team->nagain++] = answer->number;
    return UM_OK;
  }
  count(team);
  snprintf(reason, sizeof reason, "the process that computed it died, twice (%s)", answer->reason);
  return um_batch_keep(context, team->batch, answer->number, NULL, reason, true);
}

static enum um_status answered(struct um_context *context, void *self,
                               const struct um_batch_answer *answer)
{
  struct team *team = self;
  if (answer->died) return died(context, team, answer);
  if (answer->status != UM_OK && !um_batch_is_of_point(answer->status))
    return um_core_fail(context, answer->status, "%s", answer->reason);
  count(team);
  return um_batch_keep(context, team->batch, answer->number, answer->value, answer->reason,
                       answer->status == UM_ERR_LIBRARY);
}

static enum um_status work(struct um_context *context, struct team *team)
{
  struct um_batch *batch = team->batch;
  size_t number;
  while (team->answered < batch->nqueue) {
    while (um_batch_crew_idle(batch->crew) > 0 && take(team, &number))
      um_batch_crew_give(batch->crew, number, um_batch_known_coordinate(batch->known, number));
    while (batch->ranks != NULL && um_batch_ranks_idle(batch->ranks) > 0 && take(team, &number))
      um_batch_ranks_give(batch->ranks, number, um_batch_known_coordinate(batch->known, number));
    UM_TRY(um_batch_crew_wait(context, batch->crew, batch->ranks == NULL ? LOOK : LOOK_RANKS,
                              answered, team));
    if (batch->ranks != NULL) UM_TRY(um_batch_ranks_hear(context, batch->ranks, answered, team));
    UM_TRY(um_batch_tell(context, batch, &team->done, team->answered == batch->nqueue));
  }
  return UM_OK;
}

static void drop_records(void *self) { um_batch_records_drop(self); }

/* Workers first: a process with MPI is better not forked. */
static enum um_status meet(struct um_context *context, struct um_batch *batch)
{
  if (batch->crew == NULL)
    UM_TRY(um_batch_crew_create(context, &batch->task, batch->records == NULL ? NULL : drop_records,
                                batch->records, &batch->crew));
  if (batch->several && batch->ranks == NULL)
    UM_TRY(um_batch_ranks_join(context, &batch->task, &batch->ranks));
  return UM_OK;
}

enum um_status um_batch_run_team(struct um_context *context, struct um_batch *batch)
{
  enum um_status status = UM_OK;
  struct team team = {.batch = batch};
  UM_CHECK(um_core_allocate(context, batch->nqueue, sizeof *team.again, &team.again));
  UM_CHECK(meet(context, batch));
  UM_CHECK(work(context, &team));
done:
  um_core_free(context, team.again);
  /* workers that are at a point which nobody waits for: the next call forks others */
  if (status != UM_OK) um_batch_crew_destroy(context, &batch->crew);
  return status;
}

enum um_status um_batch_serve_team(struct um_context *context, struct um_batch *batch)
{
  UM_TRY(meet(context, batch));
  return um_batch_ranks_serve(context, batch->ranks, batch->crew);
}

void um_batch_end_team(struct um_context *context, struct um_batch *batch)
{
  um_batch_crew_destroy(context, &batch->crew);
  /* the others wait for a word even where there was nothing to do */
  if (batch->several && batch->rank == 0 && batch->ranks == NULL)
    (void)um_batch_ranks_join(context, &batch->task, &batch->ranks);
  um_batch_ranks_leave(context, &batch->ranks);
}
