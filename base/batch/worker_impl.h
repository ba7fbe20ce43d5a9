/* Private to base/batch/: the inside of a worker process, and how it and its parent speak. */
#ifndef UMBRA_BATCH_WORKER_IMPL_H
#define UMBRA_BATCH_WORKER_IMPL_H

#include <sys/types.h>

#include "base/batch/task.h"

/* Parent to worker: the number, then coordinates. Worker to parent: this, then values where
 * `reason` is 0, else a reason of that many bytes. */
struct um_batch_worker_head {
  uint64_t number;
  int32_t status;
  uint32_t reason; /* [byte] */
};
#define UM_BATCH_REASON_LONGEST 4096 /* [byte] */

/* In a child that has just been forked by `parent`: signals as a worker wants them, one thread;
 * then points from `end` until it is closed. Does not return. */
_Noreturn void um_batch_worker_live(struct um_context *context, const struct um_batch_task *task,
                                    int end, pid_t parent);

#endif
