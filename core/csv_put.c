/* Fields of tables that are written (RFC 4180). */
#include <string.h>

#include "core/csv.h"

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

static bool wants_quotes(const char *text, const char *tail)
{
  size_t n = strlen(text), m = strlen(tail);
  char first = n > 0 ? text[0] : tail[0], last = m > 0 ? tail[m - 1] : n > 0 ? text[n - 1] : '\0';
  return strpbrk(text, ",\"\r\n") != NULL || strpbrk(tail, ",\"\r\n") != NULL || first == '#' ||
         is_blank(first) || is_blank(last);
}

static void put_doubled(FILE *file, const char *text)
{
  for (; *text != '\0'; text++) {
    if (*text == '"') fputc('"', file);
    fputc(*text, file);
  }
}

void um_core_csv_put(FILE *file, const char *text, const char *tail)
{
  if (!wants_quotes(text, tail)) {
    fputs(text, file);
    fputs(tail, file);
    return;
  }
  fputc('"', file);
  put_doubled(file, text);
  put_doubled(file, tail);
  fputc('"', file);
}
