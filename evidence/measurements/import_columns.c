/* Which column is what, as words: one list of them, which options and the line of comment share. */
#include <stddef.h>
#include <string.h>

#include "base/core/file.h"
#include "evidence/measurements/import.h"

#define BYTES_MAX ((size_t)1 << 30)
#define MARK      "# " UM_COMPARE_IMPORT_MARK

static const struct {
  const char *word;
  size_t at;
} members[] = {
#define MEMBER(name)                                                                               \
  {                                                                                                \
#name, offsetof(struct um_compare_columns, name)                                               \
  }
    MEMBER(time), MEMBER(magnitude), MEMBER(flux),   MEMBER(counts), MEMBER(temperature),
    MEMBER(band), MEMBER(of),        MEMBER(system), MEMBER(unit),   MEMBER(sigma),
    MEMBER(flag), MEMBER(exposure),  MEMBER(track)};
#define MEMBERS (sizeof members / sizeof *members)

const char *um_compare_columns_word(size_t index)
{
  return index < MEMBERS ? members[index].word : NULL;
}

const char **um_compare_columns_member(struct um_compare_columns *columns, size_t index)
{
  return (const char **)(void *)((char *)columns + members[index].at);
}

/* "=text" with quotes where they are needed; NUL-terminated, at most size. */
static void append(char *line, size_t size, const char *word, const char *text)
{
  size_t n = strlen(line);
  bool quote = text[0] == '\0' || strpbrk(text, " \t\"") != NULL;
  n += (size_t)snprintf(line + n, size - n, "%s%s=%s", n > 0 ? " " : "", word, quote ? "\"" : "");
  for (const char *c = text; *c != '\0' && n + 3 < size; c++) {
    line[n++] = *c;
    if (*c == '"') line[n++] = '"';
  }
  if (quote) line[n++] = '"';
  line[n] = '\0';
}

enum um_status um_compare_columns_text(struct um_context *context,
                                       const struct um_compare_columns *columns, char **out)
{
  struct um_compare_columns copy = *columns;
  size_t size = 64;
  for (size_t i = 0; i < MEMBERS; i++) {
    const char *text = *um_compare_columns_member(&copy, i);
    if (text != NULL) size += 2 * strlen(text) + 32;
  }
  UM_TRY(um_core_allocate(context, size, 1, out));
  for (size_t i = 0; i < MEMBERS; i++) {
    const char *text = *um_compare_columns_member(&copy, i);
    if (text != NULL) append(*out, size, members[i].word, text);
  }
  return UM_OK;
}

/* One value in place: *at moves behind it. */
static const char *take_value(char **at)
{
  char *from = *at, *to = from;
  bool quoted = *from == '"';
  const char *value = to;
  if (quoted) from++;
  while (*from != '\0' && *from != '\n' && *from != '\r' && (quoted || *from != ' ')) {
    if (quoted && *from == '"' && *++from != '"') break; /* the end; "" is a quote */
    *to++ = *from++;
  }
  *at = from + (*from != '\0');
  *to = '\0';
  return value;
}

static enum um_status parse(struct um_context *context, const char *path, char *line,
                            struct um_compare_columns *out)
{
  for (char *at = line; *at != '\0' && *at != '\n';) {
    size_t n = strcspn(at, "=\n"), i = 0;
    while (i < MEMBERS && (strlen(members[i].word) != n || strncmp(at, members[i].word, n) != 0))
      i++;
    if (i == MEMBERS || at[n] != '=')
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: '%.*s' in its line '" MARK "...' is not understood; accepted: the "
                          "line as umbra import wrote it",
                          path, (int)(n < 40 ? n : 40), at);
    at += n + 1;
    *um_compare_columns_member(out, i) = take_value(&at);
    at += strspn(at, " ");
  }
  return UM_OK;
}

enum um_status um_compare_columns_read(struct um_context *context, const char *path,
                                       struct um_compare_columns *out, char **text)
{
  size_t length;
  *out = (struct um_compare_columns){0};
  UM_TRY(um_core_file_read(context, path, BYTES_MAX, text, &length));
  for (char *line = *text; line != NULL && *line == '#';) {
    char *next = strchr(line, '\n');
    if (strncmp(line, MARK, strlen(MARK)) == 0) {
      if (next != NULL) *next = '\0';
      char *end = line + strlen(line);
      if (end > line && end[-1] == '\r') end[-1] = '\0';
      enum um_status status = parse(context, path, line + strlen(MARK), out);
      if (status != UM_OK) {
        um_core_free(context, *text);
        *text = NULL;
      }
      return status;
    }
    line = next == NULL ? NULL : next + 1;
  }
  um_core_free(context, *text);
  *text = NULL;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: no line '" MARK "...' at its head; accepted: a file that umbra import "
                      "wrote from a table",
                      path);
}
