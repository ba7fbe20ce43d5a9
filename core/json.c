/* How texts and numbers are printed in JSON. */
#include "core/json.h"

#include <math.h>

void um_core_json_string(FILE *file, const char *text)
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

void um_core_json_number(FILE *file, double value)
{
  if (isfinite(value))
    fprintf(file, "%.9g", value == 0.0 ? 0.0 : value);
  else
    fputs("null", file);
}

void um_core_json_field(FILE *file, const char *before, const char *key, double value)
{
  fprintf(file, "%s\"%s\": ", before, key);
  um_core_json_number(file, value);
}
