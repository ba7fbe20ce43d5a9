/* Strict decimal numbers: [+-] digits [. digits] [e [+-] digits], the whole text, finite. */
#include "base/core/number.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NUMBER_LENGTH_MAX 256 /* characters; no measured value has more */

static const char *skip_digits(const char *p)
{
  while (*p >= '0' && *p <= '9') p++;
  return p;
}

/* True when the text is a decimal number from its first to its last character; *point receives the
 * place of the decimal point, or NULL. */
static bool number_shape(const char *text, const char **point)
{
  const char *p = text;
  *point = NULL;
  if (*p == '+' || *p == '-') p++;
  const char *digits = p;
  p = skip_digits(p);
  size_t count = (size_t)(p - digits);
  if (*p == '.') {
    *point = p;
    digits = ++p;
    p = skip_digits(p);
    count += (size_t)(p - digits);
  }
  if (count == 0) return false;
  if (*p == 'e' || *p == 'E') {
    p++;
    if (*p == '+' || *p == '-') p++;
    digits = p;
    p = skip_digits(p);
    if (p == digits) return false;
  }
  return *p == '\0' && p - text < NUMBER_LENGTH_MAX;
}

bool um_core_number_parse(const char *text, double *out)
{
  const char *point;
  if (text == NULL || !number_shape(text, &point)) return false;
  double value;
  const char *mark = localeconv()->decimal_point;
  if (point == NULL || strcmp(mark, ".") == 0) {
    value = strtod(text, NULL);
  } else {
    /* strtod reads the point of the current locale: hand it that one */
    char buffer[NUMBER_LENGTH_MAX + 32];
    size_t head = (size_t)(point - text), width = strlen(mark);
    if (width > 16) return false;
    memcpy(buffer, text, head);
    memcpy(buffer + head, mark, width);
    memcpy(buffer + head + width, point + 1, strlen(point + 1) + 1);
    value = strtod(buffer, NULL);
  }
  if (!isfinite(value)) return false;
  *out = value;
  return true;
}

void um_core_number_text(double value, char out[32])
{
  double again = NAN;
  for (int digits = 15; digits <= 17 && again != value; digits++) {
    snprintf(out, 32, "%.*g", digits, value == 0.0 ? 0.0 : value); /* no "-0" */
    again = strtod(out, NULL);
  }
  for (char *c = out; *c != '\0'; c++) /* the point of the current locale */
    if (strchr("+-0123456789e", *c) == NULL) *c = '.';
}
