/* Tables as others write them, made into CSV in memory, line by line. */
#include "evidence/measurements/foreign_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/core/file.h"
#include "evidence/measurements/foreign_kind.h"

#define BYTES_MAX ((size_t)1 << 30)
#define BLANK     ' ' /* as separator: any number of blanks and tabs */

/* Lines of the file. */
struct line {
  const char *begin;
  size_t length; /* without its end */
};

static bool line_next(const char **at, struct line *line)
{
  if (**at == '\0') return false;
  const char *end = strchr(*at, '\n');
  line->begin = *at;
  line->length = end == NULL ? strlen(*at) : (size_t)(end - *at);
  *at += line->length + (end != NULL);
  while (line->length > 0 && line->begin[line->length - 1] == '\r') line->length--;
  return true;
}

static struct line trimmed(struct line line)
{
  while (line.length > 0 && strchr(" \t", *line.begin) != NULL) line.begin++, line.length--;
  while (line.length > 0 && strchr(" \t", line.begin[line.length - 1]) != NULL) line.length--;
  return line;
}

/* What parts the fields of a line: the mark of which there are most outside of quotes. */
static char separator_of(struct line line)
{
  static const char marks[] = {',', ';', '\t'};
  size_t count[sizeof marks] = {0}, best = 0;
  bool quoted = false;
  line = trimmed(line);
  for (size_t i = 0; i < line.length; i++) {
    if (line.begin[i] == '"') quoted = !quoted;
    for (size_t k = 0; k < sizeof marks && !quoted; k++) count[k] += line.begin[i] == marks[k];
  }
  for (size_t k = 1; k < sizeof marks; k++)
    if (count[k] > count[best]) best = k;
  return count[best] > 0 ? marks[best] : BLANK;
}

/* The next field of a line, with its quotes; false behind the last. */
static bool field_next(struct line *rest, char separator, struct line *field)
{
  bool quoted = false;
  size_t i = 0;
  if (separator == BLANK) *rest = trimmed(*rest);
  if (rest->begin == NULL || (separator == BLANK && rest->length == 0)) return false;
  for (; i < rest->length; i++) {
    char c = rest->begin[i];
    if (c == '"') quoted = !quoted;
    if (!quoted && (separator == BLANK ? c == ' ' || c == '\t' : c == separator)) break;
  }
  *field = trimmed((struct line){rest->begin, i});
  if (i < rest->length)
    *rest = (struct line){rest->begin + i + 1, rest->length - i - 1};
  else
    *rest = (struct line){NULL, 0};
  return true;
}

/* Does it look like a number, a day or a clock, or stand for no value? */
static bool is_datum(struct line field)
{
  static const char *const none[] = {"nan", "null", "none", "indef", "n/a"};
  for (size_t i = 0; i < sizeof none / sizeof *none; i++)
    if (field.length == strlen(none[i]) && strncasecmp(field.begin, none[i], field.length) == 0)
      return true;
  for (size_t i = 0; i < field.length; i++)
    if (strchr(i == 0 ? "0123456789+-." : "0123456789+-.:/ TZeE", field.begin[i]) == NULL)
      return false;
  return true;
}

/* Fields of a line; *data: those that hold something and look like no name. */
static size_t count_fields(struct line line, char separator, size_t *data)
{
  struct line field;
  size_t n = 0;
  for (*data = 0; field_next(&line, separator, &field); n++)
    *data += field.length > 0 && is_datum(field);
  return n;
}

/* Where the header stands. */
struct head {
  size_t line;  /* number of the header's line, from 0 */
  bool comment; /* it begins with '#' */
  char separator;
};

static struct line without_mark(struct line line)
{
  line = trimmed(line);
  while (line.length > 0 && *line.begin == '#') line.begin++, line.length--;
  return trimmed(line);
}

/* Is a line of comment the names of `n` fields? Its own may be parted by blanks. */
static bool is_header(struct line comment, char separator, size_t n)
{
  size_t data;
  if (comment.length == 0) return false;
  if (count_fields(comment, separator, &data) == n && data == 0) return true;
  return count_fields(comment, BLANK, &data) == n && data == 0;
}

static enum um_status find_head(struct um_context *context, const char *path, const char *text,
                                struct head *head)
{
  struct line line, comment = {NULL, 0};
  size_t number = 0, above = 0, data;
  for (const char *at = text; line_next(&at, &line); number++) {
    struct line bare = trimmed(line);
    if (bare.length == 0) continue;
    if (*bare.begin == '#') {
      comment = without_mark(line);
      above = number;
      continue;
    }
    char separator = separator_of(line);
    size_t n = count_fields(line, separator, &data);
    *head = (struct head){number, false, separator};
    if (data == 0) return UM_OK;
    if (!is_header(comment, separator, n))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%zu: numbers where the names of the columns should stand; accepted: "
                          "a first line of names, as '# time mag error'",
                          path, number + 1);
    *head = (struct head){above, true, separator};
    return UM_OK;
  }
  return um_core_fail(context, UM_ERR_INPUT, "%s: empty; accepted: a table with a header", path);
}

/* A growing text. */
struct page {
  struct um_context *context;
  char *text;
  size_t length, capacity;
};

static enum um_status put(struct page *page, const char *bytes, size_t n)
{
  if (page->length + n + 1 > page->capacity) {
    size_t capacity = 2 * page->capacity + n + 4096;
    UM_TRY(um_core_reallocate(page->context, capacity, 1, &page->text));
    page->capacity = capacity;
  }
  memcpy(page->text + page->length, bytes, n);
  page->length += n;
  page->text[page->length] = '\0';
  return UM_OK;
}

/* One line as CSV. What holds a comma and stands in no quotes gets them. */
static enum um_status put_line(struct page *page, struct line line, char separator)
{
  struct line field;
  const char *comma = "";
  if (separator == ',') return put(page, line.begin, line.length);
  while (field_next(&line, separator, &field)) {
    bool quote = memchr(field.begin, ',', field.length) != NULL && *field.begin != '"';
    UM_TRY(put(page, comma, strlen(comma)));
    if (quote) UM_TRY(put(page, "\"", 1));
    UM_TRY(put(page, field.begin, field.length));
    if (quote) UM_TRY(put(page, "\"", 1));
    comma = ",";
  }
  return UM_OK;
}

static enum um_status convert(struct page *page, const char *text, const struct head *head)
{
  struct line line;
  size_t number = 0;
  for (const char *at = text; line_next(&at, &line); number++) {
    if (number % 4096 == 0) UM_TRY(um_core_stop_check(page->context, "a table was read"));
    struct line bare = trimmed(line);
    bool comment = bare.length == 0 || *bare.begin == '#';
    if (head->comment && number == head->line) {
      struct line names = without_mark(line);
      char separator = head->separator;
      size_t data;
      if (count_fields(names, separator, &data) == 1) separator = BLANK;
      UM_TRY(put_line(page, names, separator));
    } else if (!comment) {
      UM_TRY(put_line(page, line, head->separator));
    }
    UM_TRY(put(page, "\n", 1));
  }
  return UM_OK;
}

static const struct um_compare_foreign_kind *const kinds[] = {
#define UM_FOREIGN_KIND(name) &um_compare_foreign_##name,
#include "evidence/measurements/foreign_kinds.def"
#undef UM_FOREIGN_KIND
};

/* A file that becomes a table first. *is false: it is none. */
static enum um_status read_kind(struct um_context *context, const char *path, const char *bytes,
                                size_t length, struct um_core_csv **out, bool *is)
{
  const struct um_compare_foreign_kind *kind = NULL;
  char *text = NULL;
  size_t n = 0;
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds && kind == NULL; i++)
    if (kinds[i]->is(bytes, length)) kind = kinds[i];
  *is = kind != NULL;
  if (kind == NULL) return UM_OK;
  FILE *csv = open_memstream(&text, &n);
  if (csv == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  enum um_status status = kind->convert(context, path, bytes, length, csv);
  bool whole = fclose(csv) == 0;
  if (status == UM_OK && !whole) status = um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  if (status == UM_OK) status = um_core_csv_parse(context, path, text, n, out);
  free(text); /* of the C library */
  return status;
}

enum um_status um_compare_foreign_table_read(struct um_context *context, const char *path,
                                             struct um_core_csv **out)
{
  enum um_status status;
  char *text = NULL;
  size_t length;
  struct head head = {0};
  struct page page = {.context = context};
  *out = NULL;
  UM_CHECK(um_core_file_read(context, path, BYTES_MAX, &text, &length));
  bool is_kind, is_marked = strncmp(text, "\xef\xbb\xbf", 3) == 0; /* UTF-8 mark */
  const char *begin = is_marked ? text + 3 : text;
  UM_CHECK(read_kind(context, path, begin, length - (size_t)(begin - text), out, &is_kind));
  if (is_kind) goto done;
  if (strlen(text) != length) {
    status = um_core_fail(context, UM_ERR_INPUT, "%s: not a text file; accepted: a table", path);
    goto done;
  }
  UM_CHECK(find_head(context, path, begin, &head));
  UM_CHECK(convert(&page, begin, &head));
  UM_CHECK(um_core_csv_parse(context, path, page.text, page.length, out));
done:
  UM_FREE(context, text, page.text);
  return status;
}
