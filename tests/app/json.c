/* See json.h. A recursive descent along the grammar of RFC 8259. */
#include "tests/app/json.h"

#include <string.h>

#define DEPTH_MAX 100

static bool value(const char **at, int depth);

static void space(const char **at) { *at += strspn(*at, " \t\r\n"); }

static bool take(const char **at, const char *word)
{
  size_t n = strlen(word);
  if (strncmp(*at, word, n) != 0) return false;
  *at += n;
  return true;
}

static bool digits(const char **at)
{
  size_t n = strspn(*at, "0123456789");
  *at += n;
  return n > 0;
}

static bool number(const char **at)
{
  (void)take(at, "-");
  if (!take(at, "0") && !digits(at)) return false;
  if (take(at, ".") && !digits(at)) return false;
  if (take(at, "e") || take(at, "E")) {
    if (!take(at, "+")) (void)take(at, "-");
    if (!digits(at)) return false;
  }
  return true;
}

static bool string(const char **at)
{
  if (!take(at, "\"")) return false;
  for (; **at != '"'; (*at)++) {
    if ((unsigned char)**at < 0x20) return false; /* a control character, or the end */
    if (**at != '\\') continue;
    (*at)++;
    if (**at == '\0' || strchr("\"\\/bfnrtu", **at) == NULL) return false;
    if (**at != 'u') continue;
    if (strspn(*at + 1, "0123456789abcdefABCDEF") < 4) return false;
    *at += 4;
  }
  (*at)++;
  return true;
}

static bool members(const char **at, int depth, char close)
{
  char end[2] = {close, '\0'};
  space(at);
  if (take(at, end)) return true;
  for (;;) {
    space(at);
    if (close == '}') {
      if (!string(at)) return false;
      space(at);
      if (!take(at, ":")) return false;
    }
    if (!value(at, depth + 1)) return false;
    if (take(at, end)) return true;
    if (!take(at, ",")) return false;
  }
}

static bool value(const char **at, int depth)
{
  bool good;
  space(at);
  if (depth > DEPTH_MAX) return false;
  if (take(at, "{"))
    good = members(at, depth, '}');
  else if (take(at, "["))
    good = members(at, depth, ']');
  else if (**at == '"')
    good = string(at);
  else
    good = take(at, "true") || take(at, "false") || take(at, "null") || number(at);
  space(at);
  return good;
}

bool json_is_valid(const char *text, const char **where)
{
  *where = text;
  return value(where, 0) && **where == '\0';
}
