/* The unit that the name of a key ends in: "power_W", "conductivity_W_m_K", "layers_per_cm". The
 * first stands above the line and the others below it; an inertia's stand above it all. */
#include "library/key_unit_impl.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define WORDS 12 /* of a key at most */

static bool is_unit(const char *word)
{
  static const char *const known[] = {"m", "m2", "m3", "km",  "mm",  "cm",     "um",
                                      "s", "s2", "K",  "W",   "J",   "kg",     "au",
                                      "e", "DU", "sr", "mag", "deg", "arcsec", "arcsec2"};
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if (strcmp(word, known[i]) == 0) return true;
  return false;
}

/* "m2" -> "m^2" behind what is there. */
static void append(char out[UM_LIBRARY_UNIT], const char *between, const char *word)
{
  size_t n = strlen(word), used = strlen(out);
  bool power = n > 1 && word[n - 1] >= '2' && word[n - 1] <= '3';
  snprintf(out + used, UM_LIBRARY_UNIT - used, "%s%.*s%s%s", between, (int)(power ? n - 1 : n),
           word, power ? "^" : "", power ? word + n - 1 : "");
}

void um_library_key_unit(const char *key, char out[UM_LIBRARY_UNIT])
{
  char text[128], *word[WORDS], *rest = NULL;
  size_t n = 0, first;
  snprintf(text, sizeof text, "%s", key);
  for (char *w = strtok_r(text, "_", &rest); w != NULL && n < WORDS; w = strtok_r(NULL, "_", &rest))
    word[n++] = w;
  out[0] = '\0';
  if (n > 1 && strcmp(word[n - 1], "utc") == 0) append(out, "", "UTC");
  for (first = n; first > 1 && is_unit(word[first - 1]);) first--;
  if (first == n) return;
  bool per = strcmp(word[first - 1], "per") == 0, above = strcmp(word[0], "inertia") == 0;
  append(out, per ? "1/" : "", word[first]);
  bool many = n - first > 2;
  for (size_t i = first + 1; i < n; i++)
    append(out, above || i > first + 1 ? " " : many ? "/(" : "/", word[i]);
  if (many && !above) snprintf(out + strlen(out), UM_LIBRARY_UNIT - strlen(out), ")");
}
