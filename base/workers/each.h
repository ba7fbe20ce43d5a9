/* Tasks by number, computed by worker processes of this machine. Nothing is kept on disk
 * (base/batch/each.h does). */
#ifndef UMBRA_WORKERS_EACH_H
#define UMBRA_WORKERS_EACH_H

#include "base/core/context.h"

/* What is to be computed, and who is told. Everything is borrowed for the call. */
struct um_workers_each {
  size_t n, nvalue; /* tasks, and values that each has room for */
  /* Task `which` into value [nvalue], zero before. In a worker process: one thread, no progress, no
   * log, and nothing but `value` comes back. Deterministic: the same whatever was computed before
   * in the same process. It asks um_core_stop_check every few tenths of a second. */
  enum um_status (*compute)(struct um_context *context, void *user, size_t which, double *value);
  /* In this process, once a task, in any order: what compute returned, with its message in the
   * context where it failed. Returns what ends the work; who goes on after a failure clears the
   * message. value: [nvalue] where status is UM_OK. */
  enum um_status (*done)(struct um_context *context, void *user, size_t which,
                         enum um_status status, const double *value);
  void *user;
  int workers; /* processes, at most one a task; <= 1: this process computes, by its threads */
  void (*before)(void *self); /* as of um_workers_pool_create; NULL: nothing */
  void *before_self;
};

/* Compute all tasks; each is a step of the progress. A task whose worker dies is computed a second
 * time. Workers are forked in the call and gone at its end. Errors of `done`, UM_ERR_LIBRARY (no
 * process, or one task killed two), UM_ERR_CANCELLED, UM_ERR_MEMORY. */
enum um_status um_workers_each(struct um_context *context, const struct um_workers_each *each);

#endif
