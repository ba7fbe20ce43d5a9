/* How texts and numbers are printed in JSON, once. Write errors are left in the stream. */
#ifndef UMBRA_CORE_JSON_H
#define UMBRA_CORE_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A string literal (RFC 8259), text in UTF-8; what is no UTF-8 becomes U+FFFD, and characters that
 * are not seen (base/core/text.h) are escaped. */
void um_core_json_string(FILE *file, const char *text);
/* Nine significant digits, never "-0"; null where the value is not finite. */
void um_core_json_number(FILE *file, double value);
/* before "key": number. The key is a literal of the program. */
void um_core_json_field(FILE *file, const char *before, const char *key, double value);
/* The same of a number of things, of a text, or null where it is NULL, and of a truth. */
void um_core_json_count(FILE *file, const char *before, const char *key, size_t count);
void um_core_json_text(FILE *file, const char *before, const char *key, const char *text);
void um_core_json_bool(FILE *file, const char *before, const char *key, bool value);

#endif
