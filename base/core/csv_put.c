/* Fields of tables that are written (RFC 4180). */
#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/text.h"

static bool is_blank(char c) { return c == ' ' || c == '\t'; }

static bool wants_quotes(const char *text, const char *tail)
{
  size_t n = strlen(text), m = strlen(tail);
  char first = n > 0 ? text[0] : tail[0], last = m > 0 ? tail[m - 1] : n > 0 ? text[n - 1] : '\0';
  return strpbrk(text, ",\"\r\n") != NULL || strpbrk(tail, ",\"\r\n") != NULL || first == '#' ||
         is_blank(first) || is_blank(last) || um_core_text_runs(first);
}

static void put_inside(FILE *file, const char *text)
{
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    bool kept = c == '\n' || c == '\r' || c == '\t';
    if (*text == '"') fputc('"', file);
    if (c < 0 || (um_core_text_is_unseen(c) && !kept))
      fputc('?', file);
    else
      fwrite(text, 1, n, file);
  }
}

void um_core_csv_put(FILE *file, const char *text, const char *tail)
{
  bool quoted = wants_quotes(text, tail);
  if (quoted) fputc('"', file);
  /* behind an apostrophe a spreadsheet takes it for text; a blank is trimmed by some */
  if (um_core_text_runs(text[0] != '\0' ? text[0] : tail[0])) fputc('\'', file);
  put_inside(file, text);
  put_inside(file, tail);
  if (quoted) fputc('"', file);
}

void um_core_csv_put_text(FILE *file, const char *text, const char *tail)
{
  fputc(',', file);
  um_core_csv_put(file, text, tail);
}

void um_core_csv_put_number(FILE *file, double value)
{
  if (!isfinite(value))
    fputc(',', file);
  else
    fprintf(file, ",%.9g", value == 0.0 ? 0.0 : value); /* no "-0" */
}

void um_core_csv_put_behind(FILE *file, const char *text, double value)
{
  char number[32] = "";
  if (isfinite(value)) um_core_number_text(value, number);
  fprintf(file, "%s%s", text, number);
}

void um_core_csv_put_exact(FILE *file, double value) { um_core_csv_put_behind(file, ",", value); }
