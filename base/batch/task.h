/* What a batch is to compute. */
#ifndef UMBRA_BATCH_TASK_H
#define UMBRA_BATCH_TASK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"

/* One point: from its coordinates [ncoordinate] to its values [nvalue]. Deterministic: the same
 * bits of coordinates give the same bits of values in any process and after any other point.
 * UM_ERR_REFUSED, _INPUT, _NUMERIC, _LIBRARY: this point fails with the context's message and the
 * others go on; any other error ends the work. Called with one thread, no progress and a quiet log
 * where worker processes compute; quiet with the context's own threads where this one does. It asks
 * um_core_stop_check every few tenths of a second. */
typedef enum um_status um_batch_compute(struct um_context *context, void *user,
                                        const double *coordinate, double *value);

/* May these be the values of the point at these coordinates? A record is a file that anybody may
 * have written. */
typedef bool um_batch_accepts(void *user, const double *coordinate, const double *value);

struct um_batch_task {
  uint64_t identity;          /* of what is computed: records of another identity are refused */
  size_t ncoordinate, nvalue; /* of a point; ncoordinate > 0 */
  um_batch_compute *compute;
  um_batch_accepts *accepts; /* a record that is not accepted is none; NULL: all are */
  void *user;                /* borrowed, handed to compute and accepts */
  const char *folder;        /* where records lie; made where it is missing, its parents too */
  bool resume;    /* take the records that lie there; without it, records there are an error */
  int workers;    /* processes of this machine that compute; <= 1: this one does */
  double silence; /* of a process or rank, after which it is replaced or left out [s]; 0: 60 */
  size_t share, nshare; /* nshare > 1: of the points asked by each um_batch_run only number
                         * share, share + nshare, ... (from 0); for job arrays. Else 0, 0 */
};

#endif
