/* See progress.h. */
#include "app/progress.h"

#include <stdio.h>
#include <string.h>

#define LINE_EVERY 10.0 /* [s] */
#define FIRST_LINE 1.0  /* [s] */
#define BAR_EVERY  0.1  /* [s] */
#define BLINK      0.3  /* [s] */
#define BAR_WIDTH  28

static void begin(struct um_app_progress *p, double t, const char *task, size_t done)
{
  bool goes_on = p->task == task && done >= p->done; /* a first step may be told many times */
  p->done = done;
  if (goes_on) return;
  p->task = task;
  p->began = t;
}

/* ", 12 s left" behind `length` characters where something is done and the end is known, else ", 12
 * s so far". */
static void add_time(const struct um_app_progress *p, double t, size_t done, size_t total,
                     size_t length, char line[UM_APP_PROGRESS_LINE])
{
  if (length >= UM_APP_PROGRESS_LINE) return;
  if (done == 0 || total == 0)
    snprintf(line + length, UM_APP_PROGRESS_LINE - length, ", %.0f s so far", t - p->began);
  else
    snprintf(line + length, UM_APP_PROGRESS_LINE - length, ", %.0f s left",
             (t - p->began) * (double)(total - done) / (double)done);
}

bool um_app_progress_line(struct um_app_progress *progress, double t, const char *task, size_t done,
                          size_t total, char line[UM_APP_PROGRESS_LINE])
{
  begin(progress, t, task, done);
  if (progress->since == 0.0) progress->since = t;
  double due = progress->told > 0.0 ? progress->told + LINE_EVERY : progress->since + FIRST_LINE;
  if (t < due || (done > 0 && done == total)) return false;
  progress->told = t;
  int length;
  if (total > 0)
    length = snprintf(line, UM_APP_PROGRESS_LINE, "%.100s: %zu of %zu", task, done, total);
  else
    length = snprintf(line, UM_APP_PROGRESS_LINE, "%.100s: %zu", task, done);
  add_time(progress, t, done, total, (size_t)length, line);
  return true;
}

bool um_app_progress_bar(struct um_app_progress *progress, double t, const char *task, size_t done,
                         size_t total, char line[UM_APP_PROGRESS_LINE])
{
  begin(progress, t, task, done);
  if (t - progress->began < BLINK || t - progress->told < BAR_EVERY) return false;
  progress->told = t;
  if (total == 0) {
    snprintf(line, UM_APP_PROGRESS_LINE, "%.100s: %zu", task, done);
    return true;
  }
  char bar[BAR_WIDTH + 1];
  memset(bar, '-', BAR_WIDTH);
  memset(bar, '#', done * BAR_WIDTH / total);
  bar[BAR_WIDTH] = '\0';
  int length =
      snprintf(line, UM_APP_PROGRESS_LINE, "%.100s [%s] %3zu %%", task, bar, 100 * done / total);
  add_time(progress, t, done, total, (size_t)length, line);
  return true;
}
