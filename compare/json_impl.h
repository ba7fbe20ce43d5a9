/* How text and numbers are printed in JSON, once. Private to compare/. */
#ifndef UMBRA_COMPARE_JSON_IMPL_H
#define UMBRA_COMPARE_JSON_IMPL_H

#include <math.h>
#include <stdio.h>

/* A string literal. */
static inline void um_compare_json_string(FILE *file, const char *text)
{
  fputc('"', file);
  for (; *text != '\0'; text++) {
    unsigned char c = (unsigned char)*text;
    if (c == '"' || c == '\\')
      fprintf(file, "\\%c", c);
    else if (c < 0x20)
      fprintf(file, "\\u%04x", c);
    else
      fputc(c, file);
  }
  fputc('"', file);
}

/* Nine digits; null where it is not finite. */
static inline void um_compare_json_number(FILE *file, double value)
{
  if (isfinite(value))
    fprintf(file, "%.9g", value == 0.0 ? 0.0 : value);
  else
    fputs("null", file);
}

/* before "key": number. The key is a literal. */
static inline void um_compare_json_field(FILE *file, const char *before, const char *key,
                                         double value)
{
  fprintf(file, "%s\"%s\": ", before, key);
  um_compare_json_number(file, value);
}

#endif
