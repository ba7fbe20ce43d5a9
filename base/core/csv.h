/* Tidy CSV with a header row; '#' lines are comments; errors name file, line and column. */
#ifndef UMBRA_CORE_CSV_H
#define UMBRA_CORE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/core/context.h"
#include "base/core/number.h"

struct um_core_csv;

/* Reads a whole file. Refuses: unreadable, empty, binary (NUL bytes), rows with a wrong number of
 * fields, duplicate column names, unterminated quotes. RFC 4180 quotes, LF or CRLF, UTF-8 with or
 * without BOM; spaces around fields are trimmed. UM_ERR_IO, UM_ERR_INPUT, UM_ERR_MEMORY. */
enum um_status um_core_csv_read(struct um_context *context, const char *path,
                                struct um_core_csv **out);
/* The same from memory; `name` is what messages call it. */
enum um_status um_core_csv_parse(struct um_context *context, const char *name, const char *text,
                                 size_t length, struct um_core_csv **out);
void um_core_csv_destroy(struct um_core_csv **csv);

size_t um_core_csv_rows(const struct um_core_csv *csv);
size_t um_core_csv_columns(const struct um_core_csv *csv);
const char *um_core_csv_name(const struct um_core_csv *csv); /* the path */
const char *um_core_csv_header(const struct um_core_csv *csv, size_t column);
/* Column index by name, or (size_t)-1. */
size_t um_core_csv_find(const struct um_core_csv *csv, const char *column);
/* The same, UM_ERR_INPUT naming the file and the columns it has when missing. */
enum um_status um_core_csv_require(struct um_context *context, const struct um_core_csv *csv,
                                   const char *column, size_t *index);
/* 1-based line of a row in the file. */
int um_core_csv_line(const struct um_core_csv *csv, size_t row);
/* Text of a field, "" when empty; borrowed. */
const char *um_core_csv_text(const struct um_core_csv *csv, size_t row, size_t column);
/* A finite number; UM_ERR_INPUT "file:line: column 'x': 'abc' is not a finite number". */
enum um_status um_core_csv_number(struct um_context *context, const struct um_core_csv *csv,
                                  size_t row, size_t column, double *out);
/* UM_ERR_INPUT with "file:line: column 'x': " put before the formatted text. */
enum um_status um_core_csv_fail(struct um_context *context, const struct um_core_csv *csv,
                                size_t row, size_t column, const char *format, ...) UM_PRINTF(5, 6);

/* One field of a row that is written, `text` and what is put behind it ("" for nothing), as one
 * text by RFC 4180: in quotes where it holds a comma, a quote or an end of line, begins like a
 * comment, or begins or ends with a blank, which a reader would trim. What a spreadsheet would run
 * stands behind an apostrophe, which is read back with it (names that are read do not begin so);
 * '?' stands for control characters and bytes that are no UTF-8. Every free text of every table is
 * written by this. Errors of writing are the stream's. */
void um_core_csv_put(FILE *file, const char *text, const char *tail);
/* The next fields of a row, a comma before them: a text as above, a number with nine significant
 * digits, or with as few as read back the same; empty for what is not finite. */
void um_core_csv_put_text(FILE *file, const char *text, const char *tail);
void um_core_csv_put_number(FILE *file, double value);
void um_core_csv_put_exact(FILE *file, double value);
/* A text as it stands, and behind it a number with as few digits as read back the same; nothing of
 * what is not finite. */
void um_core_csv_put_behind(FILE *file, const char *text, double value);

/* The shortest text that is read back as the same finite number. Does not fail. */
void um_core_number_text(double value, char out[32]);

#endif
