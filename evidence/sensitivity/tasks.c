/* Tasks of a forward, and what they took: that goes before the values of a task. */
#include <string.h>

#include "evidence/sensitivity/forward.h"

struct effort {
  size_t evaluations, heat_runs, heat_sensitivities, heat_batches;
  double seconds, heat_seconds;
};
#define EFFORT ((sizeof(struct effort) + sizeof(double) - 1) / sizeof(double)) /* [doubles] */

struct work {
  const struct um_workers_each *tasks;
  struct um_sensitivity_forward *forward;
};

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct work *work = user;
  struct um_sensitivity_forward *f = work->forward;
  const struct um_sensitivity_forward before = *f;
  enum um_status status = work->tasks->compute(context, work->tasks->user, which, value + EFFORT);
  const struct effort effort = {f->evaluations - before.evaluations,
                                f->heat_runs - before.heat_runs,
                                f->heat_sensitivities - before.heat_sensitivities,
                                f->heat_batches - before.heat_batches,
                                f->seconds - before.seconds,
                                f->heat_seconds - before.heat_seconds};
  if (status != UM_OK) return status;
  *f = before; /* `done` adds it, in whichever process */
  memcpy(value, &effort, sizeof effort);
  return UM_OK;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  const struct work *work = user;
  struct um_sensitivity_forward *f = work->forward;
  if (status == UM_OK) {
    struct effort effort;
    memcpy(&effort, value, sizeof effort);
    f->evaluations += effort.evaluations;
    f->heat_runs += effort.heat_runs;
    f->heat_sensitivities += effort.heat_sensitivities;
    f->heat_batches += effort.heat_batches;
    f->seconds += effort.seconds;
    f->heat_seconds += effort.heat_seconds;
    value += EFFORT;
  }
  return work->tasks->done(context, work->tasks->user, which, status, value);
}

enum um_status um_sensitivity_forward_tasks(struct um_context *context,
                                            struct um_sensitivity_forward *forward,
                                            const struct um_workers_each *tasks)
{
  struct work work = {tasks, forward};
  struct um_workers_each counted = *tasks;
  counted.nvalue += EFFORT;
  counted.compute = compute;
  counted.done = done;
  counted.user = &work;
  return um_variant_tasks(context, forward->evaluator, forward->records, &counted);
}
