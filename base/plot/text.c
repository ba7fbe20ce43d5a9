/* What is written into a script: words of ours, numbers, and texts as string constants. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/core/text.h"
#include "base/plot/plot_impl.h"

#define TEXT_MAX 160 /* characters of a text */

/* ---- texts ---- */

/* In single quotes gnuplot takes every character as it is but the quote itself, which therefore
 * does not occur: neither `command`, nor \, $, @ or " mean anything. */
static void put_text(FILE *file, const char *text)
{
  fputc('\'', file);
  for (size_t n = 0, length; *text != '\0'; text += length, n++) {
    long c = um_core_text_character(text, &length);
    if (n == TEXT_MAX) {
      fputs("…", file);
      break;
    }
    if (c < 0)
      fputc('?', file);
    else if (um_core_text_is_unseen(c))
      fputc(' ', file);
    else if (c == '\'')
      fputs("’", file);
    else
      fwrite(text, 1, length, file);
  }
  fputc('\'', file);
}

/* ---- formats ---- */

static void put_double(FILE *file, const char *conversion, double value)
{
  if (isfinite(value))
    fprintf(file, conversion, value);
  else
    fputs("NaN", file);
}

void um_plot_add(struct um_plot *plot, const char *format, ...)
{
  va_list arguments;
  va_start(arguments, format);
  for (const char *at = format; *at != '\0'; at++) {
    if (*at != '%') {
      fputc(*at, plot->file);
      continue;
    }
    char conversion[16];
    size_t n = 1 + strspn(at + 1, "-+ #0123456789.z");
    assert(n + 2 <= sizeof conversion);
    memcpy(conversion, at, n + 1);
    conversion[n + 1] = '\0';
    at += n;
    switch (*at) {
    case '%':
      fputc('%', plot->file);
      break;
    case 's':
      put_text(plot->file, va_arg(arguments, const char *));
      break;
    case 'd':
      fprintf(plot->file, conversion, va_arg(arguments, int));
      break;
    case 'u':
      if (conversion[n - 1] == 'z')
        fprintf(plot->file, conversion, va_arg(arguments, size_t));
      else
        fprintf(plot->file, conversion, va_arg(arguments, unsigned));
      break;
    default:
      assert(strchr("efgEG", *at) != NULL);
      put_double(plot->file, conversion, va_arg(arguments, double));
    }
  }
  va_end(arguments);
}
