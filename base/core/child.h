/* Work in a child process, which may crash, run on or ask for too much memory. */
#ifndef UMBRA_CORE_CHILD_H
#define UMBRA_CORE_CHILD_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "base/core/context.h"

struct um_core_child_limits {
  double seconds;  /* of wall clock and of processor [s] */
  size_t megabyte; /* of memory beyond what this process has; SIZE_MAX: no limit */
};

enum um_core_child_end { UM_CHILD_EXITED, UM_CHILD_SIGNALLED, UM_CHILD_TIMED_OUT };

struct um_core_child_result {
  char *answer; /* [count] what the work wrote; the caller frees with um_core_free */
  size_t count;
  enum um_core_child_end end;
  int code; /* of the exit, or the signal */
};

/* What the child does: writes its answer to `pipe_end` (never 0, 1 or 2; closed by an exec) and
 * returns the exit code. It has one thread, and stdin, stdout and stderr lead to /dev/null. */
typedef int (*um_core_child_work)(void *self, int pipe_end);

/* Fork, run `work` under the limits, collect the answer until the child has ended. The child dies
 * with this process, leaves no core file, and has ended when this returns, whatever comes back.
 * `name`: in messages, e.g. "gnuplot". UM_ERR_LIBRARY: no process could be started; UM_ERR_MEMORY;
 * UM_ERR_CANCELLED: a stop was asked for. How the work ended, well or ill, is in `out`. */
enum um_status um_core_child_run(struct um_context *context, const char *name,
                                 um_core_child_work work, void *self,
                                 const struct um_core_child_limits *limits,
                                 struct um_core_child_result *out);

/* Before a fork whose child goes on to use libraries with threads of their own (TBB below Embree):
 * a lock that one of them holds while it runs would stay locked in the child for good. Waits until
 * every other thread of this process sleeps, for `seconds` at most. Does not fail. */
void um_core_child_settle(double seconds);

/* End a child by SIGKILL, whatever it does; *state: of waitpid. One that the system cannot end, as
 * while its disk does not answer, is left behind after 5 s, and *state is left as it was. */
void um_core_child_end(pid_t child, int *state);

/* write() of all bytes for use in a child; false when the reader is gone or the disk is full. */
bool um_core_child_write(int pipe_end, const void *data, size_t bytes);

#endif
