/* What a worker process is to compute. */
#ifndef UMBRA_WORKERS_TASK_H
#define UMBRA_WORKERS_TASK_H

#include <stddef.h>

#include "base/core/context.h"

/* One point: from its coordinates [ncoordinate] to its values [nvalue]. Deterministic: the same
 * bits of coordinates give the same bits of values in any process and after any other point.
 * Called with one thread, no progress and a quiet log in a worker process; quiet with the context's
 * own threads where no worker is forked. It asks um_core_stop_check every few tenths of a second.
 */
typedef enum um_status um_workers_compute(struct um_context *context, void *user,
                                          const double *coordinate, double *value);

#define UM_WORKERS_REASON_LONGEST 4096 /* of a failure; longer ones are cut [byte] */

struct um_workers_task {
  size_t ncoordinate, nvalue; /* of a point; ncoordinate > 0 */
  um_workers_compute *compute;
  void *user;     /* borrowed, handed to compute */
  int workers;    /* processes of this machine that compute */
  double silence; /* of a process, after which it is replaced [s]; 0: UM_WORKERS_SILENCE */
};

#endif
