/* A worker process: reads coordinates, computes, writes values. */
#include "base/workers/worker_impl.h"

#include <errno.h>
#include <fcntl.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/core/child.h"

static bool read_all(int end, void *out, size_t bytes)
{
  char *at = out;
  while (bytes > 0) {
    ssize_t n = read(end, at, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    bytes -= (size_t)n;
  }
  return true;
}

/* Ctrl-C and scancel reach the whole group; the parent decides what becomes of a worker, and ends
 * it by SIGKILL, which nothing here is harmed by: it writes no file. */
static void prepare(struct um_context *context, pid_t parent)
{
  static const int ignored[] = {SIGINT, SIGTERM, SIGHUP, SIGXFSZ};
  for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++) signal(ignored[i], SIG_IGN);
  signal(SIGALRM, SIG_DFL);
  signal(SIGPIPE, SIG_DFL);
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(1);
  setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
  int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (null >= 0) {
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    if (null > STDERR_FILENO) close(null);
  }
  omp_set_num_threads(1);
  um_core_context_set_threads(context, 1);
  um_core_context_set_stop(context, NULL, NULL);
  um_core_progress_set_sink(context, NULL, NULL);
  um_core_quiet_begin(context);
}

static bool answer(struct um_context *context, const struct um_workers_task *task, int end,
                   uint64_t number, enum um_status status, const double *value)
{
  const char *reason = um_core_message(context);
  if (status != UM_OK && reason[0] == '\0') reason = um_core_status_text(status);
  size_t length = status == UM_OK ? 0 : strnlen(reason, UM_WORKERS_REASON_LONGEST);
  struct um_workers_answer_head head = {number, (int32_t)status, (uint32_t)length};
  return um_core_child_write(end, &head, sizeof head) &&
         um_core_child_write(end, status == UM_OK ? (const void *)value : reason,
                             status == UM_OK ? task->nvalue * sizeof *value : length);
}

_Noreturn void um_workers_worker_run(struct um_context *context, const struct um_workers_task *task,
                                     int end, pid_t parent)
{
  uint64_t number;
  prepare(context, parent);
  double *coordinate = calloc(task->ncoordinate, sizeof *coordinate);
  double *value = calloc(task->nvalue > 0 ? task->nvalue : 1, sizeof *value);
  if (coordinate == NULL || value == NULL) _exit(1);
  while (read_all(end, &number, sizeof number) &&
         read_all(end, coordinate, task->ncoordinate * sizeof *coordinate)) {
    um_core_message_clear(context);
    memset(value, 0, task->nvalue * sizeof *value);
    enum um_status status = task->compute(context, task->user, coordinate, value);
    if (!answer(context, task, end, number, status, value)) break;
  }
  _exit(0);
}
