/* Private to base/batch/, the only place that knows MPI: processes that mpirun or srun started
 * together. Rank 0 leads: it decides what is computed and keeps the records. The others hand points
 * to their own workers. No process computes itself, so that each always hears the others. Without
 * MPI (ranks_none.c) a process is alone. */
#ifndef UMBRA_BATCH_RANKS_IMPL_H
#define UMBRA_BATCH_RANKS_IMPL_H

#include "base/batch/task.h"
#include "base/workers/pool.h"

struct um_batch_ranks;

/* Was this process started as one of several, and as which (0 when alone)? From the environment, at
 * no cost. UM_ERR_INPUT: one of several, in a build without MPI. */
enum um_status um_batch_ranks_look(struct um_context *context, bool *several, size_t *rank);

/* Meet the others, after the pool was forked: a process with MPI is better not forked. The task is
 * borrowed. UM_ERR_INPUT: MPI places this process elsewhere than the environment does;
 * UM_ERR_LIBRARY, UM_ERR_MEMORY. */
enum um_status um_batch_ranks_join(struct um_context *context, const struct um_batch_task *task,
                                   struct um_batch_ranks **out);

/* Rank 0: workers elsewhere without a point. */
size_t um_batch_ranks_idle(const struct um_batch_ranks *ranks);
/* Rank 0: give a point to one of those; there is one. */
void um_batch_ranks_give(struct um_batch_ranks *ranks, size_t number, const double *coordinate);
/* Rank 0: hand on what has arrived, without waiting. Points of a rank that has not been heard of
 * for a minute are answered as those of a worker that died. Errors of `answered`; UM_ERR_INPUT: a
 * rank has another task; what ended the work of a rank. */
enum um_status um_batch_ranks_hear(struct um_context *context, struct um_batch_ranks *ranks,
                                   um_workers_answered *answered, void *self);

/* Other ranks: compute by the pool what rank 0 hands out, until it closes. */
enum um_status um_batch_ranks_serve(struct um_context *context, struct um_batch_ranks *ranks,
                                    struct um_workers_pool *pool);

/* Rank 0 tells the others to end. Accepts NULL, sets NULL. */
void um_batch_ranks_leave(struct um_context *context, struct um_batch_ranks **ranks);

#endif
