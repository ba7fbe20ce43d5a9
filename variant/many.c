/* Many variants at once: what they share is computed before workers are forked. */
#include "variant/many.h"

enum um_status um_variant_tasks(struct um_context *context, struct um_variant_evaluator *evaluator,
                                struct um_batch *records, const struct um_workers_each *tasks)
{
  size_t share = tasks->workers > 1 ? (size_t)tasks->workers : 1;
  size_t bound = um_variant_evaluator_bound(evaluator, 0);
  um_variant_evaluator_bound(evaluator, bound / share);
  enum um_status status = um_batch_each(context, records, tasks);
  um_variant_evaluator_bound(evaluator, bound);
  return status;
}

struct work {
  const struct um_variant_each *each;
  struct um_variant_evaluator *evaluator;
};

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  enum um_status status;
  const struct work *work = user;
  const struct um_variant_each *each = work->each;
  struct um_variant v = {0};
  struct um_model_result *result = NULL;
  UM_CHECK(um_variant_open(context, work->evaluator, &each->changes[which], each->heat, &v));
  UM_CHECK(um_variant_observe(context, work->evaluator, &v, &result));
  UM_CHECK(each->take(context, each->user, which, &v, result, value));
done:
  um_model_result_destroy(context, &result);
  um_variant_close(context, &v);
  return status;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  const struct work *work = user;
  return work->each->done(context, work->each->user, which, status, value);
}

enum um_status um_variant_each(struct um_context *context, struct um_variant_evaluator *evaluator,
                               const struct um_variant_each *each)
{
  struct work work = {each, evaluator};
  const struct um_workers_each tasks = {.n = each->n,
                                        .nvalue = each->nvalue,
                                        .compute = compute,
                                        .done = done,
                                        .user = &work,
                                        .workers = each->workers};
  bool light = false;
  for (size_t i = 0; i < each->n; i++) light = light || um_variant_acts_behind(&each->changes[i]);
  um_core_quiet_begin(context); /* the progress is the caller's */
  enum um_status status = um_variant_share(context, evaluator, each->heat->start, light);
  um_core_quiet_end(context);
  UM_TRY(status);
  return um_variant_tasks(context, evaluator, NULL, &tasks);
}
