/* The text of a new scenario, block by block. */
#include <string.h>

#include "app/app.h"
#include "app/new.h"

static const char *line_end(const char *line)
{
  const char *end = strchr(line, '\n');
  return end == NULL ? line + strlen(line) : end + 1;
}

/* The line that begins with "key:"; NULL where there is none. */
static const char *find_key(const char *text, const char *key)
{
  size_t n = strlen(key);
  for (const char *line = text; *line != '\0'; line = line_end(line))
    if (strncmp(line, key, n) == 0 && line[n] == ':') return line;
  return NULL;
}

/* Behind the value: the lines that stand further in, and empty ones between them. */
static const char *value_end(const char *line)
{
  const char *end = line_end(line);
  for (const char *next = end; *next == ' ' || *next == '\n'; next = line_end(next))
    if (*next == ' ') end = line_end(next);
  return end;
}

/* The first of the lines of comment right above. */
static const char *comment_begin(const char *text, const char *line)
{
  const char *begin = line;
  while (begin > text) {
    const char *above = begin - 1;
    while (above > text && above[-1] != '\n') above--;
    if (*above != '#') break;
    begin = above;
  }
  return begin;
}

enum um_status um_app_new_put(struct um_context *context, char **text, const char *key,
                              const char *comment, const char *value)
{
  const char *line = find_key(*text, key);
  char *made;
  if (line == NULL)
    return um_core_fail(context, UM_ERR_INPUT, "the template has no '%s'; accepted: one as it came",
                        key);
  const char *begin = comment == NULL ? line : comment_begin(*text, line);
  UM_TRY(um_core_asprintf(context, &made, "%.*s%s%s%s", (int)(begin - *text), *text,
                          comment == NULL ? "" : comment, value, value_end(line)));
  um_core_free(context, *text);
  *text = made;
  return UM_OK;
}
