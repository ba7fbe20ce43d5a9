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

#define BAR_WIDTH  28
#define TELL_EVERY 10.0 /* in a pipe [s] */

struct progress {
  const char *task;
  double began, drawn; /* [s] */
};

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

static void log_line(void *self, enum um_core_log_level level, const char *line)
{
  (void)self;
  if (level < UM_LOG_INFO || (level == UM_LOG_INFO && !isatty(STDERR_FILENO))) return;
  um_app_terminal_clear();
  fprintf(stderr, "%s%s\n",
          level == UM_LOG_WARNING ? "warning: "
          : level == UM_LOG_ERROR ? "error: "
                                  : "",
          line);
}

static bool in_pipes; /* progress is told there, too */

void um_app_terminal_progress_in_pipes(void) { in_pipes = true; }

/* A line of its own, now and then. */
static void tell(struct progress *p, const char *task, size_t done, size_t total)
{
  double t = now();
  if (p->task != task || done == 0 || p->drawn == 0.0) {
    if (p->task != task || done == 0) p->began = t;
    p->task = task;
    p->drawn = p->began;
  }
  if (done == 0 || done == total || t - p->drawn < TELL_EVERY) return;
  p->drawn = t;
  fprintf(stderr, "%s: %zu of %zu, %.0f s left\n", task, done, total,
          (t - p->began) * (double)(total - done) / (double)done);
  fflush(stderr);
}

static bool draw(void *self, const char *task, size_t done, size_t total)
{
  struct progress *p = self;
  if (stop(NULL)) return false;
  if (!isatty(STDERR_FILENO)) {
    if (in_pipes) tell(p, task, done, total);
    return true;
  }
  double t = now();
  if (p->task != task || done == 0) {
    p->task = task;
    p->began = t;
    p->drawn = 0.0;
  }
  if (done == total) {
    um_app_terminal_clear();
    return true;
  }
  if (t - p->began < 0.3 || t - p->drawn < 0.1) return true;
  p->drawn = t;
  char bar[BAR_WIDTH + 1];
  size_t filled = total == 0 ? 0 : done * BAR_WIDTH / total;
  memset(bar, '-', BAR_WIDTH);
  memset(bar, '#', filled);
  bar[BAR_WIDTH] = '\0';
  double left = done == 0 ? 0.0 : (t - p->began) * (double)(total - done) / (double)done;
  fprintf(stderr, "\r\033[K%s [%s] %3zu %%", task, bar, total == 0 ? 0 : 100 * done / total);
  if (done > 0) fprintf(stderr, ", %.0f s left", left);
  fflush(stderr);
  return true;
}

void um_app_terminal_attach(struct um_context *context)
{
  static struct progress progress; /* one terminal, one bar */
  um_core_log_set_sink(context, log_line, NULL);
  um_core_progress_set_sink(context, draw, &progress);
  um_core_context_set_stop(context, stop, NULL);
  listen_all();
}
