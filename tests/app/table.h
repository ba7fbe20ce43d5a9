/* A CSV file as its fields, strictly: every row has as many fields as the header, no quotes. */
#ifndef UMBRA_TESTS_APP_TABLE_H
#define UMBRA_TESTS_APP_TABLE_H

#include <stddef.h>

struct table {
  char *text, *header; /* header: the first line as it stands */
  size_t ncolumn, nrow;
  char **field; /* [nrow + 1][ncolumn], row 0 is the header */
};

/* The test fails when the file is not such a table. */
struct table table_read(const char *path);
void table_release(struct table *table);
/* Column by name; the test fails when there is none. */
size_t table_column(const struct table *table, const char *name);
/* Field of a row counted from 0 without the header. */
const char *table_text(const struct table *table, size_t row, const char *column);
/* Its number; the test fails when it is empty or no number. */
double table_number(const struct table *table, size_t row, const char *column);

#endif
