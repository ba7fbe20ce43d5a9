/* See table.h. */
#include "tests/app/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"

static size_t count(const char *text, size_t length, char c)
{
  size_t n = 0;
  for (size_t i = 0; i < length; i++) n += text[i] == c;
  return n;
}

struct table table_read(const char *path)
{
  struct table t = {.text = command_read(path)};
  size_t length = strlen(t.text), first = strcspn(t.text, "\n");
  if (length == 0 || t.text[length - 1] != '\n') fail_msg("%s: no line end at its end", path);
  if (strpbrk(t.text, "\"\r") != NULL) fail_msg("%s: quotes or carriage returns", path);
  t.header = calloc(first + 1, 1);
  assert_non_null(t.header);
  memcpy(t.header, t.text, first);
  t.ncolumn = count(t.text, first, ',') + 1;
  t.nrow = count(t.text, length, '\n') - 1;
  t.field = calloc((t.nrow + 1) * t.ncolumn, sizeof *t.field);
  assert_non_null(t.field);
  char *at = t.text;
  for (size_t i = 0; i < (t.nrow + 1) * t.ncolumn; i++) {
    t.field[i] = at;
    at += strcspn(at, ",\n");
    char wanted = (i + 1) % t.ncolumn == 0 ? '\n' : ',';
    if (*at != wanted) fail_msg("%s: row %zu has not %zu fields", path, i / t.ncolumn, t.ncolumn);
    *at++ = '\0';
  }
  return t;
}

void table_release(struct table *table)
{
  free(table->text);
  free(table->header);
  free(table->field);
}

size_t table_column(const struct table *table, const char *name)
{
  for (size_t i = 0; i < table->ncolumn; i++)
    if (strcmp(table->field[i], name) == 0) return i;
  fail_msg("no column '%s' in %s", name, table->header);
  return 0;
}

const char *table_text(const struct table *table, size_t row, const char *column)
{
  assert_true(row < table->nrow);
  return table->field[(row + 1) * table->ncolumn + table_column(table, column)];
}

double table_number(const struct table *table, size_t row, const char *column)
{
  const char *text = table_text(table, row, column);
  char *end;
  double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value))
    fail_msg("row %zu, column %s: '%s' is not a number", row, column, text);
  return value;
}
