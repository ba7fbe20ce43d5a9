/* Points of work computed by many processes. Every point that is done is safe on disk, and work
 * that was stopped at any moment goes on from there. Knows nothing of satellites. */
#ifndef UMBRA_BATCH_BATCH_H
#define UMBRA_BATCH_BATCH_H

#include "base/batch/task.h"

struct um_batch;

/* Open the records of a task. A record that was not written whole is cut off (with a warning), what
 * stands before it is kept. UM_ERR_IO: records of something else, records without `resume`, a
 * folder that another process works in or that cannot be written; UM_ERR_MEMORY. The task and its
 * folder's name are copied; `user` outlives the batch. Out: the caller closes. */
enum um_status um_batch_open(struct um_context *context, const struct um_batch_task *task,
                             struct um_batch **out);
/* Points on record. */
size_t um_batch_recorded(const struct um_batch *batch);

/* Compute n points, except those on record and those asked twice. coordinate: [n][ncoordinate];
 * value: [n][nvalue], in the order asked, NaN in a point that failed; reason: [n], NULL where the
 * point is done, else why it failed, which the caller frees by um_core_free each. A point that is
 * refused is on record with its reason; one whose worker died is computed a second time, then is
 * lost: not on record, and tried again after a resume. So is one that a library failed at. Points
 * counted as done by the context's progress are on the disk. May be called again and again; worker
 * processes are forked at the first call that has something to compute and see nothing of what the
 * caller changes later. Errors: those of compute, UM_ERR_IO (the disk is full: what is on record
 * stays valid), UM_ERR_CANCELLED, UM_ERR_LIBRARY (no process), UM_ERR_MEMORY; the reasons are all
 * NULL then. */
enum um_status um_batch_run(struct um_context *context, struct um_batch *batch,
                            const double *coordinate, size_t n, double *value, char **reason);

/* Points that this process has lost. Records are to stay then. */
size_t um_batch_lost(const struct um_batch *batch);
/* Say in one warning which of n points are lost, and why the first one is: `what` ("points.csv:
 * point") and their numbers, which begin with `first`. coordinate [n][ncoordinate]. */
void um_batch_tell_lost(struct um_context *context, struct um_batch *batch,
                        const double *coordinate, size_t n, const char *what, size_t first);

/* Under mpirun or srun every rank opens the same task, and all but one serve that one. True: this
 * process decides what is computed, by um_batch_run. Always true elsewhere. */
bool um_batch_leads(const struct um_batch *batch);
/* For a process that does not lead: compute what the leading one hands out, until that closes.
 * Errors as um_batch_run. */
enum um_status um_batch_serve(struct um_context *context, struct um_batch *batch);

/* Ends the worker processes; records stay. Accepts NULL, sets NULL. */
void um_batch_close(struct um_context *context, struct um_batch **batch);

#endif
