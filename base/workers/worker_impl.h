/* Private to base/workers/: the inside of a worker process, and how it and its parent speak. */
#ifndef UMBRA_WORKERS_WORKER_IMPL_H
#define UMBRA_WORKERS_WORKER_IMPL_H

#include <stdint.h>
#include <sys/types.h>

#include "base/workers/task.h"

/* Parent to worker: the number, then coordinates. Worker to parent: this, then values where
 * `reason` is 0, else a reason of that many bytes. */
struct um_workers_answer_head {
  uint64_t number;
  int32_t status;
  uint32_t reason; /* [byte] */
};

/* In a child that has just been forked by `parent`: signals as a worker wants them, one thread;
 * then points from `end` until it is closed. Does not return. */
_Noreturn void um_workers_worker_run(struct um_context *context, const struct um_workers_task *task,
                                     int end, pid_t parent);

#endif
