/* A build without MPI: every process is alone. */
#include <stdlib.h>

#include "base/batch/ranks_impl.h"

enum um_status um_batch_ranks_look(struct um_context *context, bool *several, size_t *rank)
{
  *several = false;
  *rank = 0;
  const char *size = getenv("OMPI_COMM_WORLD_SIZE");
  if (size == NULL) size = getenv("PMI_SIZE");
  if (size == NULL || strtol(size, NULL, 10) <= 1) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "started as one of %s processes, but built without MPI; accepted: one "
                      "process, or a build where CMake finds MPI",
                      size);
}

enum um_status um_batch_ranks_join(struct um_context *context, const struct um_batch_task *task,
                                   struct um_batch_ranks **out)
{
  (void)task;
  *out = NULL;
  return um_core_fail(context, UM_ERR_LIBRARY, "built without MPI");
}

size_t um_batch_ranks_idle(const struct um_batch_ranks *ranks)
{
  (void)ranks;
  return 0;
}

void um_batch_ranks_give(struct um_batch_ranks *ranks, size_t number, const double *coordinate)
{
  (void)ranks;
  (void)number;
  (void)coordinate;
}

enum um_status um_batch_ranks_hear(struct um_context *context, struct um_batch_ranks *ranks,
                                   um_workers_answered *answered, void *self)
{
  (void)context;
  (void)ranks;
  (void)answered;
  (void)self;
  return UM_OK;
}

enum um_status um_batch_ranks_serve(struct um_context *context, struct um_batch_ranks *ranks,
                                    struct um_workers_pool *pool)
{
  (void)ranks;
  (void)pool;
  return um_core_fail(context, UM_ERR_LIBRARY, "built without MPI");
}

void um_batch_ranks_leave(struct um_context *context, struct um_batch_ranks **ranks)
{
  (void)context;
  (void)ranks;
}
