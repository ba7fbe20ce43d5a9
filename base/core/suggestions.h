/* Suggestions in messages: lists of what is accepted, and the nearest to what was written. */
#ifndef UMBRA_CORE_SUGGESTIONS_H
#define UMBRA_CORE_SUGGESTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/text.h"

/* The same text, where NULL is the empty one: names of targets, of which a global effect has none.
 * Does not fail. */
bool um_core_words_same(const char *a, const char *b);

/* Append `word` to the NUL-terminated text in `buffer` as "a, b, c"; ends in "..." where the buffer
 * is full. Does not fail. size >= 8. */
void um_core_words_append(char *buffer, size_t size, const char *word);

/* Distance between a word as written and a known one: letters added, left out, changed or swapped
 * with their neighbour (optimal string alignment, after Damerau 1964) without regard to case; 1
 * when the known word only adds a unit ("height" and "height_m"). Words beyond 63 characters are
 * compared by their first 63. */
size_t um_core_words_distance(const char *written, const char *known);
/* Near enough to be suggested: at most a third of the longer word, and at least 1. */
int um_core_words_are_near(const char *written, const char *known);

/* The nearest of the words that were considered; begin with {.written = what was typed}. */
struct um_core_words_guess {
  const char *written, *nearest; /* borrowed; nearest is NULL where nothing is near enough */
  size_t distance;
};
/* Of two that are equally near the first stays. Does not fail. */
void um_core_words_consider(struct um_core_words_guess *guess, const char *known);
#define UM_CORE_WORDS_HINT 96
/* "; did you mean 'NEAREST'?", or "" where nothing is near; returns out. Does not fail. */
const char *um_core_words_hint(const struct um_core_words_guess *guess,
                               char out[UM_CORE_WORDS_HINT]);

#endif
