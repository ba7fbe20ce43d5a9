/* CSV with a header row (RFC 4180 with '#' comment lines). The text is kept once; fields are
 * unquoted in place and addressed by pointers into it. */
#include "base/core/csv.h"

#include <stdint.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/text.h"

#define CSV_BYTES_MAX ((size_t)1 << 30)
#define COLUMNS_MAX   10000 /* each name is compared with each */

struct um_core_csv {
  struct um_context *context;
  char *name;
  char *text;    /* shape [length + 1], fields end in NUL */
  char **fields; /* shape [row + header][column], borrowed from text */
  int *lines;    /* shape [row + header], 1-based */
  size_t columns, records;
  size_t field_capacity, line_capacity, field_count;
};

/* Reading position. */
struct cursor {
  char *p, *end;
  int line; /* 1-based */
};

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

static enum um_status push_field(struct um_core_csv *csv, char *field)
{
  if (csv->field_count == csv->field_capacity) {
    size_t capacity = 2 * csv->field_capacity + 64;
    UM_TRY(um_core_reallocate(csv->context, capacity, sizeof *csv->fields, &csv->fields));
    csv->field_capacity = capacity;
  }
  csv->fields[csv->field_count++] = field;
  return UM_OK;
}

static enum um_status push_record(struct um_core_csv *csv, int line)
{
  if (csv->records == csv->line_capacity) {
    size_t capacity = 2 * csv->line_capacity + 64;
    UM_TRY(um_core_reallocate(csv->context, capacity, sizeof *csv->lines, &csv->lines));
    csv->line_capacity = capacity;
  }
  csv->lines[csv->records++] = line;
  return UM_OK;
}

/* Step over blank lines and comment lines; false at the end of the text. */
static bool next_record(struct cursor *c)
{
  while (c->p < c->end) {
    char *q = c->p;
    while (q < c->end && is_blank(*q)) q++;
    if (q < c->end && *q != '#' && *q != '\n') return true;
    while (q < c->end && *q != '\n') q++;
    c->p = q < c->end ? q + 1 : q;
    c->line++;
  }
  return false;
}

/* A quoted field; c->p stands behind the opening quote. Doubled quotes become one, in place. */
static enum um_status read_quoted(struct um_core_csv *csv, struct cursor *c, char **field,
                                  char **field_end)
{
  int line = c->line;
  char *w = c->p;
  *field = w;
  for (;; c->p++) {
    if (c->p == c->end)
      return um_core_fail(csv->context, UM_ERR_INPUT, "%s:%d: a quote that opens here never closes",
                          csv->name, line);
    if (*c->p == '"') {
      if (c->p + 1 == c->end || c->p[1] != '"') break;
      c->p++;
    } else if (*c->p == '\n') {
      c->line++;
    }
    *w++ = *c->p;
  }
  *field_end = w;
  for (c->p++; c->p < c->end && is_blank(*c->p);) c->p++;
  if (c->p < c->end && *c->p != ',' && *c->p != '\n')
    return um_core_fail(csv->context, UM_ERR_INPUT,
                        "%s:%d: text behind a closing quote; accepted: a comma or the end of line",
                        csv->name, c->line);
  return UM_OK;
}

/* One field; c->p is left on the comma, the newline or the end. */
static enum um_status read_field(struct um_core_csv *csv, struct cursor *c, char **field,
                                 char **field_end)
{
  while (c->p < c->end && is_blank(*c->p)) c->p++;
  if (c->p < c->end && *c->p == '"') {
    c->p++;
    return read_quoted(csv, c, field, field_end);
  }
  *field = c->p;
  while (c->p < c->end && *c->p != ',' && *c->p != '\n') c->p++;
  char *e = c->p;
  while (e > *field && is_blank(e[-1])) e--;
  *field_end = e;
  return UM_OK;
}

/* One record: all fields up to the end of its line. */
static enum um_status read_record(struct um_core_csv *csv, struct cursor *c)
{
  int line = c->line;
  UM_TRY(push_record(csv, line));
  size_t count = 0;
  for (;;) {
    char *field = c->p, *field_end = c->p;
    UM_TRY(read_field(csv, c, &field, &field_end));
    char stop = c->p < c->end ? *c->p : '\n';
    *field_end = '\0';
    /* the apostrophe that um_core_csv_put and spreadsheets put before what is no formula */
    if (field[0] == '\'' && um_core_text_runs(field[1])) field++;
    UM_TRY(push_field(csv, field));
    count++;
    if (c->p < c->end) c->p++;
    if (stop == '\n') break;
  }
  c->line++;
  if (csv->records == 1) csv->columns = count;
  if (count == csv->columns) return UM_OK;
  return um_core_fail(csv->context, UM_ERR_INPUT,
                      "%s:%d: %zu fields; accepted: %zu, as many as the header has columns",
                      csv->name, line, count, csv->columns);
}

static enum um_status check_header(struct um_core_csv *csv)
{
  if (csv->columns > COLUMNS_MAX)
    return um_core_fail(csv->context, UM_ERR_INPUT, "%s:%d: %zu columns; accepted: at most %d",
                        csv->name, csv->lines[0], csv->columns, COLUMNS_MAX);
  for (size_t i = 0; i < csv->columns; i++) {
    if (csv->fields[i][0] == '\0')
      return um_core_fail(csv->context, UM_ERR_INPUT, "%s:%d: column %zu has no name in the header",
                          csv->name, csv->lines[0], i + 1);
    for (size_t j = 0; j < i; j++)
      if (strcmp(csv->fields[i], csv->fields[j]) == 0)
        return um_core_fail(csv->context, UM_ERR_INPUT, "%s:%d: column '%s' appears twice",
                            csv->name, csv->lines[0], csv->fields[i]);
  }
  return UM_OK;
}

static enum um_status parse_records(struct um_core_csv *csv, size_t length)
{
  struct cursor c = {csv->text, csv->text + length, 1};
  if (length >= 3 && memcmp(c.p, "\xef\xbb\xbf", 3) == 0) c.p += 3;
  const char *nul = memchr(c.p, '\0', (size_t)(c.end - c.p));
  if (nul != NULL)
    return um_core_fail(csv->context, UM_ERR_INPUT,
                        "%s: not a text file (zero byte at offset %zu); accepted: CSV", csv->name,
                        (size_t)(nul - csv->text));
  while (next_record(&c)) {
    bool header = csv->records == 0;
    if (csv->records % 4096 == 0) UM_TRY(um_core_stop_check(csv->context, "a table was read"));
    UM_TRY(read_record(csv, &c));
    if (header) UM_TRY(check_header(csv));
  }
  if (csv->records == 0)
    return um_core_fail(csv->context, UM_ERR_INPUT, "%s: empty; accepted: CSV with a header row",
                        csv->name);
  return UM_OK;
}

/* Takes over `text`, shape [length + 1]. */
static enum um_status parse_owned(struct um_context *context, const char *name, char *text,
                                  size_t length, struct um_core_csv **out)
{
  struct um_core_csv *csv = NULL;
  enum um_status status = um_core_allocate(context, 1, sizeof *csv, &csv);
  if (status != UM_OK) {
    um_core_free(context, text);
    return status;
  }
  csv->context = context;
  csv->text = text;
  UM_CHECK(um_core_strdup(context, name, &csv->name));
  UM_CHECK(parse_records(csv, length));
  *out = csv;
  csv = NULL;
done:
  um_core_csv_destroy(&csv);
  return status;
}

enum um_status um_core_csv_read(struct um_context *context, const char *path,
                                struct um_core_csv **out)
{
  char *text;
  size_t length;
  *out = NULL;
  UM_TRY(um_core_file_read(context, path, CSV_BYTES_MAX, &text, &length));
  return parse_owned(context, path, text, length, out);
}

enum um_status um_core_csv_parse(struct um_context *context, const char *name, const char *text,
                                 size_t length, struct um_core_csv **out)
{
  char *copy;
  *out = NULL;
  UM_TRY(um_core_allocate(context, length + 1, 1, &copy));
  if (length > 0) memcpy(copy, text, length);
  return parse_owned(context, name, copy, length, out);
}

void um_core_csv_destroy(struct um_core_csv **csv)
{
  if (csv == NULL || *csv == NULL) return;
  struct um_context *context = (*csv)->context;
  UM_FREE(context, (*csv)->name, (*csv)->text, (*csv)->fields, (*csv)->lines, *csv);
  *csv = NULL;
}

size_t um_core_csv_rows(const struct um_core_csv *csv) { return csv->records - 1; }
size_t um_core_csv_columns(const struct um_core_csv *csv) { return csv->columns; }
const char *um_core_csv_name(const struct um_core_csv *csv) { return csv->name; }

const char *um_core_csv_header(const struct um_core_csv *csv, size_t column)
{
  return csv->fields[column];
}

size_t um_core_csv_find(const struct um_core_csv *csv, const char *column)
{
  for (size_t i = 0; i < csv->columns; i++)
    if (strcmp(csv->fields[i], column) == 0) return i;
  return SIZE_MAX;
}

enum um_status um_core_csv_require(struct um_context *context, const struct um_core_csv *csv,
                                   const char *column, size_t *index)
{
  *index = um_core_csv_find(csv, column);
  if (*index != SIZE_MAX) return UM_OK;
  char have[512];
  size_t used = 0;
  have[0] = '\0';
  for (size_t i = 0; i < csv->columns && used < sizeof have; i++)
    used += (size_t)snprintf(have + used, sizeof have - used, "%s%s", i == 0 ? "" : ", ",
                             csv->fields[i]);
  return um_core_fail(context, UM_ERR_INPUT, "%s:%d: column '%s' is missing; the file has: %s",
                      csv->name, csv->lines[0], column, have);
}

int um_core_csv_line(const struct um_core_csv *csv, size_t row) { return csv->lines[row + 1]; }

const char *um_core_csv_text(const struct um_core_csv *csv, size_t row, size_t column)
{
  return csv->fields[(row + 1) * csv->columns + column];
}

enum um_status um_core_csv_number(struct um_context *context, const struct um_core_csv *csv,
                                  size_t row, size_t column, double *out)
{
  const char *text = um_core_csv_text(csv, row, column);
  if (row % 256 == 0) UM_TRY(um_core_stop_check(context, "a table was read"));
  if (um_core_number_parse(text, out)) return UM_OK;
  return um_core_csv_fail(context, csv, row, column, "'%s' is not a finite number", text);
}

enum um_status um_core_csv_fail(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, size_t column, const char *format, ...)
{
  char text[768];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return um_core_fail(context, UM_ERR_INPUT, "%s:%d: column '%s': %s", csv->name,
                      um_core_csv_line(csv, row), csv->fields[column], text);
}
