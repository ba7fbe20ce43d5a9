/* What foreign text may hold. */
#include "base/core/text.h"

#include <string.h>

long um_core_text_character(const char *text, size_t *length)
{
  static const struct {
    unsigned char mask, lead;
    long least;
  } form[] = {{0x80, 0x00, 0}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};
  const unsigned char *at = (const unsigned char *)text;
  *length = 1;
  for (size_t n = 0; n < sizeof form / sizeof form[0]; n++) {
    if ((at[0] & form[n].mask) != form[n].lead) continue;
    long c = at[0] & ~form[n].mask;
    for (size_t i = 1; i <= n; i++) {
      if ((at[i] & 0xc0) != 0x80) return -1; /* the end of the text too */
      c = c << 6 | (at[i] & 0x3f);
    }
    if (c < form[n].least || c > 0x10ffff || (c >= 0xd800 && c <= 0xdfff)) return -1;
    *length = n + 1;
    return c;
  }
  return -1;
}

bool um_core_text_is_control(long c) { return (c >= 0 && c < 0x20) || (c >= 0x7f && c < 0xa0); }

bool um_core_text_is_unseen(long c)
{
  return um_core_text_is_control(c) || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

bool um_core_text_is_plain(const char *text)
{
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    bool kept = c == '\t' || c == '\n' || c == '\r' || c == 0x85; /* blanks and ends of lines */
    if (c < 0 || (um_core_text_is_control(c) && !kept)) return false;
  }
  return true;
}

bool um_core_text_runs(char first) { return first != '\0' && strchr("=+-@\t\r", first) != NULL; }

void um_core_text_put(FILE *file, const char *text)
{
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    if (c < 0 || um_core_text_is_unseen(c))
      fputc('?', file);
    else
      fwrite(text, 1, n, file);
  }
}

static bool is_plain_in_a_shell(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         (unsigned char)c >= 0x80 || (c != '\0' && strchr("@%+=:,./_-", c) != NULL);
}

void um_core_text_put_word(FILE *file, const char *text)
{
  bool plain = text[0] != '\0';
  for (const char *c = text; *c != '\0'; c++) plain = plain && is_plain_in_a_shell(*c);
  if (!plain) fputc('\'', file);
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    if (c < 0 || um_core_text_is_unseen(c))
      fputc('?', file);
    else if (c == '\'') /* ends the quotes, stands by itself, and begins them again */
      fputs("'\\''", file);
    else
      fwrite(text, 1, n, file);
  }
  if (!plain) fputc('\'', file);
}

void um_core_text_make_line(char *text)
{
  for (size_t n; *text != '\0'; text += n) {
    long c = um_core_text_character(text, &n);
    if (c < 0 || um_core_text_is_unseen(c)) memset(text, c >= 0 && n == 1 ? ' ' : '?', n);
  }
}

bool um_core_name_is_safe_behind(const char *name)
{
  if (strlen(name) > UM_CORE_NAME_LONGEST) return false;
  for (size_t n; *name != '\0'; name += n) {
    long c = um_core_text_character(name, &n);
    if (c < 0 || um_core_text_is_unseen(c) || strchr("`\"\\$", *name) != NULL) return false;
  }
  return true;
}

bool um_core_name_is_safe(const char *name)
{
  return !um_core_text_runs(name[0]) && um_core_name_is_safe_behind(name);
}
