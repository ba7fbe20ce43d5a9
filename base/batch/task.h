/* What a batch is to compute. */
#ifndef UMBRA_BATCH_TASK_H
#define UMBRA_BATCH_TASK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/workers/task.h"

/* May these be the values of the point at these coordinates? A record is a file that anybody may
 * have written. user: that of the work. */
typedef bool um_batch_accepts(void *user, const double *coordinate, const double *value);

struct um_batch_task {
  uint64_t identity; /* of what is computed: records of another identity are refused */
  /* What is computed. UM_ERR_REFUSED, _INPUT, _NUMERIC, _LIBRARY: this point fails with the
   * context's message and the others go on; any other error ends the work. workers <= 1: this
   * process computes. silence holds for ranks, too. */
  struct um_workers_task work;
  um_batch_accepts *accepts; /* a record that is not accepted is none; NULL: all are */
  const char *folder;        /* where records lie; made where it is missing, its parents too */
  bool resume; /* take the records that lie there; without it, records there are an error */
  bool alone;  /* no ranks serve it: this process computes all, whoever started it */
  size_t share, nshare; /* nshare > 1: of the points asked by each um_batch_run only number
                         * share, share + nshare, ... (from 0); for job arrays. Else 0, 0 */
};

#endif
