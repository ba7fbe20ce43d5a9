/* What foreign text may hold where it is named, printed or written: characters of UTF-8 (RFC 3629).
 */
#ifndef UMBRA_CORE_TEXT_H
#define UMBRA_CORE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The character at `text`, of `*length` bytes; -1, and a length of 1: bytes that are no UTF-8. Does
 * not fail. */
long um_core_text_character(const char *text, size_t *length);
/* A control character (C0, DEL, C1): a terminal may obey it. */
bool um_core_text_is_control(long character);
/* That, an end of line or a mark of writing direction: what is read is not what is shown. */
bool um_core_text_is_unseen(long character);

/* UTF-8 without control characters but ends of lines and tabs? */
bool um_core_text_is_plain(const char *text);
/* Would a spreadsheet run a field that begins with this character (= + - @, tab, CR)? */
bool um_core_text_runs(char first);

/* Print a text in one line: '?' for each byte that is no UTF-8 or of a character that is not seen.
 * For what others named, as files. Errors of writing are the stream's. */
void um_core_text_put(FILE *file, const char *text);
/* Print a text as one word of a command line of POSIX sh, to be shown and copied: in quotes where
 * it holds more than letters, digits, bytes above ASCII and @%+=:,./_-. '?' as above. */
void um_core_text_put_word(FILE *file, const char *text);
/* The first in place: control characters of one byte become blanks. */
void um_core_text_make_line(char *text);

/* May this name a thing? Names reach tables, scripts of pictures and messages: a backtick, a double
 * quote, a backslash, a dollar, a character that is not seen or no UTF-8 in one is refused wherever
 * a name is read, so are the first characters at which a spreadsheet takes a field for a formula,
 * and more than 255 bytes, the longest name that a file may have. */
bool um_core_name_is_safe(const char *name);
/* The same of a name that is written only behind another, as a group's "+x" in "bus.+x": any first
 * character. */
bool um_core_name_is_safe_behind(const char *name);
#define UM_CORE_NAME_LONGEST 255
#define UM_CORE_NAME_ACCEPTED_BEHIND                                                               \
  "a name of at most 255 bytes without control characters and without ` \" \\ $"
#define UM_CORE_NAME_ACCEPTED UM_CORE_NAME_ACCEPTED_BEHIND ", its first character none of = + - @"

#endif
