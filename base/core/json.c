/* How texts and numbers are printed in JSON. */
#include "base/core/json.h"

#include <math.h>

#include "base/core/text.h"

void um_core_json_string(FILE *file, const char *text)
{
  fputc('"', file);
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    if (c == '"' || c == '\\')
      fprintf(file, "\\%c", *text);
    else if (c < 0 || um_core_text_is_unseen(c))
      fprintf(file, "\\u%04lx", (unsigned long)(c < 0 ? 0xfffd : c));
    else
      fwrite(text, 1, n, file);
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

void um_core_json_count(FILE *file, const char *before, const char *key, size_t count)
{
  fprintf(file, "%s\"%s\": %zu", before, key, count);
}

void um_core_json_text(FILE *file, const char *before, const char *key, const char *text)
{
  fprintf(file, "%s\"%s\": ", before, key);
  if (text == NULL)
    fputs("null", file);
  else
    um_core_json_string(file, text);
}

void um_core_json_bool(FILE *file, const char *before, const char *key, bool value)
{
  fprintf(file, "%s\"%s\": %s", before, key, value ? "true" : "false");
}
