/* Values of options that several verbs take. */
#include <string.h>

#include "app/app.h"
#include "base/core/csv.h"

bool um_app_noise_parse(const char *text, double fallback_floor, double *relative, double *floor)
{
  char first[64];
  const char *comma = strchr(text, ',');
  size_t n = comma == NULL ? strlen(text) : (size_t)(comma - text);
  if (n >= sizeof first) return false;
  memcpy(first, text, n);
  first[n] = '\0';
  *floor = fallback_floor;
  return um_core_number_parse(first, relative) &&
         (comma == NULL || um_core_number_parse(comma + 1, floor));
}
