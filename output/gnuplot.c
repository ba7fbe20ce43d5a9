/* gnuplot as a child process. */
#include <errno.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "output/gnuplot_impl.h"
#include "output/output.h"

#define NOT_FOUND 127

static int run_child(const char *folder, const char *script)
{
  fflush(NULL);
  pid_t child = fork();
  if (child == 0) {
    if (chdir(folder) != 0 || freopen("gnuplot.log", "w", stderr) == NULL) _exit(126);
    execlp("gnuplot", "gnuplot", script, (char *)NULL);
    _exit(NOT_FOUND);
  }
  int state = 0;
  if (child < 0) return -1;
  while (waitpid(child, &state, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
}

void um_output_gnuplot_run(struct um_context *context, const char *folder, const char *script)
{
  char log[4096];
  int code = run_child(folder, script);
  snprintf(log, sizeof log, "%s/gnuplot.log", folder);
  if (code == 0 || code == NOT_FOUND) (void)remove(log);
  if (code == NOT_FOUND)
    um_core_log(context, UM_LOG_WARNING,
                "no pictures: gnuplot is not installed; %s in the results draws them later",
                script);
  else if (code != 0)
    um_core_log(context, UM_LOG_WARNING, "gnuplot failed with code %d on %s, see gnuplot.log", code,
                script);
}

void um_output_plot_script(struct um_context *context, const char *folder, const char *script)
{
  um_output_gnuplot_run(context, folder, script);
}
