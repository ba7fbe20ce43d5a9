/* What is written into a script: words of ours, numbers, and texts as string constants. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "plot/plot_impl.h"

#define TEXT_MAX 160 /* characters of a text */

/* ---- texts ---- */

/* The character at `text`, of `*length` bytes; -1: bytes that are no UTF-8 (RFC 3629). */
static long character(const unsigned char *text, size_t *length)
{
  static const struct {
    unsigned char mask, lead;
    long least;
  } form[] = {{0x80, 0x00, 0}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};
  *length = 1;
  for (size_t n = 0; n < sizeof form / sizeof form[0]; n++) {
    if ((text[0] & form[n].mask) != form[n].lead) continue;
    long c = text[0] & ~form[n].mask;
    for (size_t i = 1; i <= n; i++) {
      if ((text[i] & 0xc0) != 0x80) return -1; /* the end of the text too */
      c = c << 6 | (text[i] & 0x3f);
    }
    if (c < form[n].least || c > 0x10ffff || (c >= 0xd800 && c <= 0xdfff)) return -1;
    *length = n + 1;
    return c;
  }
  return -1;
}

/* Control characters, ends of lines, marks of writing direction. */
static bool is_unseen(long c)
{
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

/* In single quotes gnuplot takes every character as it is but the quote itself, which therefore
 * does not occur: neither `command`, nor \, $, @ or " mean anything. */
static void put_text(FILE *file, const char *text)
{
  const unsigned char *at = (const unsigned char *)text;
  fputc('\'', file);
  for (size_t n = 0, length; *at != '\0'; at += length, n++) {
    long c = character(at, &length);
    if (n == TEXT_MAX) {
      fputs("…", file);
      break;
    }
    if (c < 0)
      fputc('?', file);
    else if (is_unseen(c))
      fputc(' ', file);
    else if (c == '\'')
      fputs("’", file);
    else
      fwrite(at, 1, length, file);
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
