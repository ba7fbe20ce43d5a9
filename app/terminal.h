/* Log and progress on the terminal. */
#ifndef UMBRA_APP_TERMINAL_H
#define UMBRA_APP_TERMINAL_H

#include "core/context.h"

/* Warnings and errors go to stderr always, information and a progress bar with the time left only
 * when stderr is a terminal. SIGINT and SIGTERM cancel work at its next step of progress. */
void um_app_terminal_attach(struct um_context *context);
/* Remove a progress bar from the line. */
void um_app_terminal_clear(void);

#endif
