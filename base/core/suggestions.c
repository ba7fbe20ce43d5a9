/* Suggestions in messages. */
#include "base/core/suggestions.h"

#include <stdio.h>
#include <string.h>

bool um_core_words_same(const char *a, const char *b)
{
  return strcmp(a == NULL ? "" : a, b == NULL ? "" : b) == 0;
}

#define WORD_MAX 63

void um_core_words_append(char *buffer, size_t size, const char *word)
{
  size_t used = strlen(buffer), need = strlen(word) + (used > 0 ? 2 : 0);
  if (used >= 3 && strcmp(buffer + used - 3, "...") == 0) return;
  if (used + need + 6 > size)
    snprintf(buffer + used, size - used, "%s...", used > 0 ? ", " : "");
  else
    snprintf(buffer + used, size - used, "%s%s", used > 0 ? ", " : "", word);
}

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

static size_t word_length(const char *word)
{
  size_t n = strlen(word);
  return n > WORD_MAX ? WORD_MAX : n;
}

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

size_t um_core_words_distance(const char *written, const char *known)
{
  size_t n = word_length(written), m = word_length(known);
  if (n > 0 && m > n && known[n] == '_' && strncmp(written, known, n) == 0) return 1;
  /* row[j]: distance of the first i characters of `written` to the first j of `known`; the two rows
   * above it are kept */
  size_t rows[3][WORD_MAX + 1], *two = rows[0], *above = rows[1], *row = rows[2];
  for (size_t j = 0; j <= m; j++) row[j] = j;
  for (size_t i = 1; i <= n; i++) {
    size_t *oldest = two;
    two = above;
    above = row;
    row = oldest;
    row[0] = i;
    for (size_t j = 1; j <= m; j++) {
      char a = lower(written[i - 1]), b = lower(known[j - 1]);
      row[j] = least(least(above[j], row[j - 1]) + 1, above[j - 1] + (a == b ? 0 : 1));
      if (i > 1 && j > 1 && a == lower(known[j - 2]) && lower(written[i - 2]) == b)
        row[j] = least(row[j], two[j - 2] + 1);
    }
  }
  return row[m];
}

int um_core_words_are_near(const char *written, const char *known)
{
  size_t longer = word_length(written), m = word_length(known);
  if (m > longer) longer = m;
  size_t limit = longer / 3 > 1 ? longer / 3 : 1;
  return um_core_words_distance(written, known) <= limit;
}

void um_core_words_consider(struct um_core_words_guess *guess, const char *known)
{
  if (!um_core_words_are_near(guess->written, known)) return;
  size_t distance = um_core_words_distance(guess->written, known);
  if (guess->nearest != NULL && distance >= guess->distance) return;
  guess->nearest = known;
  guess->distance = distance;
}

const char *um_core_words_hint(const struct um_core_words_guess *guess,
                               char out[UM_CORE_WORDS_HINT])
{
  out[0] = '\0';
  if (guess->nearest != NULL)
    snprintf(out, UM_CORE_WORDS_HINT, "; did you mean '%.70s'?", guess->nearest);
  return out;
}
