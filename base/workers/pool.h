/* A pool of worker processes of this machine. Each is a child with one thread that computes one
 * point at a time. It dies with this process. It is replaced when it dies by itself or is silent:
 * it has a point, and its processor clock stands still. A point may take hours, so long as its
 * worker uses the processor. */
#ifndef UMBRA_WORKERS_POOL_H
#define UMBRA_WORKERS_POOL_H

#include <stdbool.h>

#include "base/workers/task.h"

#define UM_WORKERS_SILENCE 60.0 /* where the task does not say [s] */

struct um_workers_pool;

/* What became of a point. */
struct um_workers_answer {
  size_t number;         /* the point's, as it was given */
  enum um_status status; /* of compute; UM_OK when the worker died, too */
  bool died;             /* the worker did, before it could answer */
  const double *value;   /* [nvalue] where status is UM_OK and died is not set; borrowed */
  const char *reason;    /* elsewhere; borrowed */
};
typedef enum um_status um_workers_answered(struct um_context *context, void *self,
                                           const struct um_workers_answer *answer);

/* Fork task->workers children, at least one. The task is borrowed until the pool is destroyed.
 * before: called in each child with `before_self` first thing (NULL: nothing), to close what is not
 * its own. UM_ERR_LIBRARY: no process; UM_ERR_MEMORY. */
enum um_status um_workers_pool_create(struct um_context *context,
                                      const struct um_workers_task *task,
                                      void (*before)(void *self), void *before_self,
                                      struct um_workers_pool **out);
/* Workers, and those of them without a point. */
size_t um_workers_pool_size(const struct um_workers_pool *pool);
size_t um_workers_pool_idle(const struct um_workers_pool *pool);
/* Give a point to a worker without one; there is one. */
void um_workers_pool_give(struct um_workers_pool *pool, size_t number, const double *coordinate);
/* Wait for answers at most this long [s], and hand each on. Errors of `answered`, UM_ERR_LIBRARY
 * where a dead worker cannot be replaced. */
enum um_status um_workers_pool_wait(struct um_context *context, struct um_workers_pool *pool,
                                    double seconds, um_workers_answered *answered, void *self);
/* Ends the workers, whatever they do. Accepts NULL, sets NULL. */
void um_workers_pool_destroy(struct um_context *context, struct um_workers_pool **pool);

#endif
