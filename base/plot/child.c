/* gnuplot as a child process. */
#include <stdio.h>
#include <unistd.h>

#include "base/core/child.h"
#include "base/plot/plot_impl.h"

#define NO_FOLDER  126
#define NOT_FOUND  127
#define TIME_LIMIT 120.0 /* [s] */
#define MEMORY     4096  /* [MB] */

struct work {
  const char *folder;
  const char *const *arguments;
};

/* In the child. */
static int child_work(void *self, int pipe_end)
{
  const struct work *work = self;
  (void)pipe_end;
  if (chdir(work->folder) != 0 || freopen("gnuplot.log", "w", stderr) == NULL) return NO_FOLDER;
  execvp(work->arguments[0], (char *const *)work->arguments);
  return NOT_FOUND;
}

static void say(struct um_context *context, const struct um_core_child_result *result,
                const char *script)
{
  bool exited = result->end == UM_CHILD_EXITED;
  if (exited && result->code == NOT_FOUND)
    um_core_log(context, UM_LOG_WARNING,
                "no pictures: gnuplot is not installed; %s in the results draws them later",
                script);
  else if (result->end == UM_CHILD_TIMED_OUT)
    um_core_log(context, UM_LOG_WARNING, "gnuplot did not finish %s within %g s and was ended",
                script, TIME_LIMIT);
  else if (!exited || result->code != 0)
    um_core_log(context, UM_LOG_WARNING, "gnuplot failed with %s %d on %s, see gnuplot.log",
                exited ? "code" : "signal", result->code, script);
}

enum um_status um_plot_child(struct um_context *context, const char *folder, const char *script,
                             const char *const *arguments)
{
  char *log = NULL;
  struct work work = {folder, arguments};
  const struct um_core_child_limits limits = {TIME_LIMIT, MEMORY};
  struct um_core_child_result result;
  UM_TRY(um_core_asprintf(context, &log, "%s/gnuplot.log", folder));
  enum um_status status =
      um_core_child_run(context, "gnuplot", child_work, &work, &limits, &result);
  if (status == UM_OK) {
    um_core_free(context, result.answer);
    if (result.end == UM_CHILD_EXITED && (result.code == 0 || result.code == NOT_FOUND))
      (void)remove(log);
    say(context, &result, script);
  } else if (status == UM_ERR_LIBRARY) {
    um_core_log(context, UM_LOG_WARNING, "no pictures: %s", um_core_message(context));
    um_core_message_clear(context);
    status = UM_OK;
  }
  um_core_free(context, log);
  return status;
}
