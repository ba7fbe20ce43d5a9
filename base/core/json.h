/* How texts and numbers are printed in JSON, once. Write errors are left in the stream. */
#ifndef UMBRA_CORE_JSON_H
#define UMBRA_CORE_JSON_H

#include <stdio.h>

/* A string literal (RFC 8259), text in UTF-8; what is no UTF-8 becomes U+FFFD, and characters that
 * are not seen (base/core/text.h) are escaped. */
void um_core_json_string(FILE *file, const char *text);
/* Nine significant digits, never "-0"; null where the value is not finite. */
void um_core_json_number(FILE *file, double value);
/* before "key": number. The key is a literal of the program. */
void um_core_json_field(FILE *file, const char *before, const char *key, double value);

#endif
