/* What readers of foreign files line by line share. */
#ifndef UMBRA_COMPARE_FOREIGN_LINE_H
#define UMBRA_COMPARE_FOREIGN_LINE_H

#include "base/core/context.h"

/* Where a reader stands. */
struct um_compare_foreign_at {
  struct um_context *context;
  const char *path;
  int line; /* from 1; 0 before the first */
};

/* UM_ERR_INPUT "path:line: 'what'; accepted: ...". */
enum um_status um_compare_foreign_refuse(const struct um_compare_foreign_at *at, const char *what,
                                         const char *accepted);
/* The text between its blanks; what stands behind is cut off. */
char *um_compare_foreign_trimmed(char *text);
/* The next line of *rest, ended where its '\n' was, NULL behind the last. An end of the text right
 * behind a '\n' begins no line. */
char *um_compare_foreign_line(struct um_compare_foreign_at *at, char **rest);

#endif
