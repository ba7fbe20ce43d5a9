/* What is said of work that lasts: a bar with the time left, or a line now and then. */
#ifndef UMBRA_APP_PROGRESS_H
#define UMBRA_APP_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

/* Of the work under way; all zero before the first. Times of a clock that only goes on [s]. */
struct um_app_progress {
  const char *task; /* borrowed; tasks are told apart by their address */
  double began;     /* the task */
  size_t done;      /* of it, when it was last heard of */
  double told;      /* the last bar or line, of any task; 0: none */
  double since;     /* the first call; 0: there was none */
};

/* Longest line, with its end. */
#define UM_APP_PROGRESS_LINE 200

/* done of total steps at time t, total 0: nobody knows how many. True: a line is due, which is in
 * line. In a pipe: 10 s after the last one, the first a second after the first call, whatever task
 * it was of. */
bool um_app_progress_line(struct um_app_progress *progress, double t, const char *task, size_t done,
                          size_t total, char line[UM_APP_PROGRESS_LINE]);
/* The same for a terminal, where the last bar is overwritten: ten times a second, of tasks that
 * last longer than a blink. */
bool um_app_progress_bar(struct um_app_progress *progress, double t, const char *task, size_t done,
                         size_t total, char line[UM_APP_PROGRESS_LINE]);

#endif
