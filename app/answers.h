/* What commands print with --json: the one list of it is answers.def. */
#ifndef UMBRA_APP_ANSWERS_H
#define UMBRA_APP_ANSWERS_H

#include <stdio.h>

/* The JSON Schema (draft 2020-12) of a command, one object; it allows no key that it does not name.
 * Errors of writing are the stream's. */
void um_app_answer_schema(FILE *file, const char *command);

#endif
