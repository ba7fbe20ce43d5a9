/* Log and progress on the terminal: a bar with the time left, nothing of it in a pipe; Ctrl-C. */
#include "app/terminal.h"

#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "app/app.h"
#include "app/progress.h"

/* SIGINT and SIGTERM: the work stops at its next step and takes its unfinished results away. What
 * one call into a foreign library keeps longer than PATIENCE ends with the process, whose children
 * die with it and whose unfinished folder the next run removes. A second signal ends the process at
 * once. */
#define PATIENCE 1.0 /* [s] */

static atomic_int interrupted; /* the signal's number */
static timer_t deadline;
static bool has_deadline;

static void interrupt(int signal_number)
{
  static const struct itimerspec patience = {
      .it_value = {(time_t)PATIENCE, (long)((PATIENCE - (double)(time_t)PATIENCE) * 1e9)}};
  atomic_store(&interrupted, signal_number);
  if (has_deadline) (void)timer_settime(deadline, 0, &patience, NULL);
}

static void give_up(int signal_number)
{
  (void)signal_number;
  _exit(UM_APP_SIGNAL + atomic_load(&interrupted));
}

static void listen(int signal_number)
{
  struct sigaction action = {.sa_handler = interrupt, .sa_flags = (int)SA_RESETHAND};
  struct sigaction before;
  /* a signal that the caller has switched off stays off */
  if (sigaction(signal_number, NULL, &before) == 0 && before.sa_handler != SIG_IGN)
    (void)sigaction(signal_number, &action, NULL);
}

static void listen_all(void)
{
  struct sigaction alarm_action = {.sa_handler = give_up}, ignore = {.sa_handler = SIG_IGN};
  struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGALRM};
  has_deadline = sigaction(SIGALRM, &alarm_action, NULL) == 0 &&
                 timer_create(CLOCK_MONOTONIC, &event, &deadline) == 0;
  /* a file that reaches its largest size is an error of its write */
  (void)sigaction(SIGXFSZ, &ignore, NULL);
  listen(SIGINT);
  listen(SIGTERM);
}

static bool stop(void *self)
{
  (void)self;
  return atomic_load_explicit(&interrupted, memory_order_relaxed) != 0;
}

int um_app_terminal_signal(void) { return atomic_load(&interrupted); }

void um_app_terminal_open_standard(void)
{
  int fd;
  do fd = open("/dev/null", O_RDWR);
  while (fd >= 0 && fd <= STDERR_FILENO);
  if (fd >= 0) close(fd);
}

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void um_app_terminal_clear(void)
{
  if (isatty(STDERR_FILENO)) fputs("\r\033[K", stderr);
}

void um_app_terminal_log(int level, const char *line)
{
  if (level < UM_LOG_INFO || (level == UM_LOG_INFO && !isatty(STDERR_FILENO))) return;
  um_app_terminal_clear();
  fprintf(stderr, "%s%s\n",
          level == UM_LOG_WARNING ? "warning: "
          : level == UM_LOG_ERROR ? "error: "
                                  : "",
          line);
}

static void log_line(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  um_app_terminal_log((int)level, line);
}

static bool in_pipes; /* progress is told there, too */

void um_app_terminal_progress_in_pipes(void) { in_pipes = true; }

static bool draw(void *self, const char *task, size_t done, size_t total)
{
  char line[UM_APP_PROGRESS_LINE];
  if (stop(NULL)) return false;
  if (!isatty(STDERR_FILENO)) {
    if (in_pipes && um_app_progress_line(self, now(), task, done, total, line)) {
      fprintf(stderr, "%s\n", line);
      fflush(stderr);
    }
    return true;
  }
  if (done == total) um_app_terminal_clear(); /* it ends */
  if (um_app_progress_bar(self, now(), task, done, total, line) && done != total) {
    fprintf(stderr, "\r\033[K%s", line);
    fflush(stderr);
  }
  return true;
}

void um_app_terminal_attach(struct um_context *context)
{
  static struct um_app_progress progress; /* one terminal, one bar */
  um_core_log_set_sink(context, log_line, NULL);
  um_core_progress_set_sink(context, draw, &progress);
  um_core_context_set_stop(context, stop, NULL);
  listen_all();
}
