/* A strict check of JSON syntax (RFC 8259). */
#ifndef UMBRA_TESTS_APP_JSON_H
#define UMBRA_TESTS_APP_JSON_H

#include <stdbool.h>

/* True when the whole text is one JSON value, with white space around it; else *where is where it
 * stops to be. Numbers, strings with their escapes, nesting up to 100. */
bool json_is_valid(const char *text, const char **where);

#endif
