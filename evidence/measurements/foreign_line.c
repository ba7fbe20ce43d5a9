/* Lines of foreign files. */
#include "evidence/measurements/foreign_line.h"

#include <string.h>

enum um_status um_compare_foreign_refuse(const struct um_compare_foreign_at *at, const char *what,
                                         const char *accepted)
{
  return um_core_fail(at->context, UM_ERR_INPUT, "%s:%d: '%.60s'; accepted: %s", at->path, at->line,
                      what, accepted);
}

char *um_compare_foreign_trimmed(char *text)
{
  text += strspn(text, " \t\r");
  size_t n = strlen(text);
  while (n > 0 && strchr(" \t\r", text[n - 1]) != NULL) text[--n] = '\0';
  return text;
}

char *um_compare_foreign_line(struct um_compare_foreign_at *at, char **rest)
{
  char *line = *rest;
  if (line == NULL) return NULL;
  char *end = line + strcspn(line, "\n");
  *rest = *end != '\0' && end[1] != '\0' ? end + 1 : NULL;
  *end = '\0';
  at->line++;
  return line;
}
