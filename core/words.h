/* Words in messages: lists of what is accepted, and the nearest of them to what was written. */
#ifndef UMBRA_CORE_WORDS_H
#define UMBRA_CORE_WORDS_H

#include <stddef.h>

/* Append `word` to the NUL-terminated text in `buffer` as "a, b, c"; ends in "..." where the buffer
 * is full. Does not fail. size >= 8. */
void um_core_words_append(char *buffer, size_t size, const char *word);

/* Distance between a word as written and a known one: edit distance (Levenshtein 1966) without
 * regard to case; 1 when the known word only adds a unit ("height" and "height_m"). Words beyond 63
 * characters are compared by their first 63. */
size_t um_core_words_distance(const char *written, const char *known);
/* Near enough to be suggested: at most a third of the longer word, and at least 1. */
int um_core_words_are_near(const char *written, const char *known);

#endif
