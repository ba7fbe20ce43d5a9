/* Log and progress on the terminal. */
#ifndef UMBRA_APP_TERMINAL_H
#define UMBRA_APP_TERMINAL_H

#include "base/core/context.h"

/* Warnings and errors go to stderr always, information and a progress bar with the time left only
 * when stderr is a terminal. SIGINT and SIGTERM stop the work through the context's stop; where
 * nothing asks for 1 s the process ends all the same. SIGXFSZ is ignored, so that a file too
 * large is an error. */
void um_app_terminal_attach(struct um_context *context);
/* A line of the log, of a level as um_core_log_level counts. */
void um_app_terminal_log(int level, const char *line);
/* From now on progress is told where stderr is no terminal, too: a line of its own, the first after
 * 1 s, then every 10 s. For work of minutes and more that is watched through a file. */
void um_app_terminal_progress_in_pipes(void);
/* The signal that asked to stop, or 0. */
int um_app_terminal_signal(void);
/* /dev/null where the caller has closed stdin, stdout or stderr, so that no file or pipe of ours
 * gets their numbers. Before anything is opened. */
void um_app_terminal_open_standard(void);
/* Remove a progress bar from the line. */
void um_app_terminal_clear(void);

#endif
