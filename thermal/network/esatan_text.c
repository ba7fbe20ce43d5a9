/* ESATAN's files .d as statements: blocks begin with $, data end with ';', Mortran by the line. */
#include <ctype.h>
#include <string.h>

#include "thermal/network/esatan_impl.h"
#include "thermal/network/network_group.h"

#define ACCEPTED                                                                                   \
  "accepted: $MODEL, $LOCALS, $NODES, $CONDUCTORS, $CONSTANTS, $ARRAYS, $EVENTS, $SUBROUTINES, "   \
  "$INITIAL, $VARIABLES1, $VARIABLES2, $EXECUTION, $OUTPUTS, $ENDMODEL"

struct splitter {
  struct um_context *context;
  const char *path;
  char *at;
  int line;
  bool begun, ended, mortran, text; /* text: values in quotes, of which nothing is read */
  enum um_thermal_esatan_block block;
  struct um_thermal_esatan_statement *statement;
  size_t n, room;
};

size_t um_thermal_esatan_word(const char *text)
{
  size_t n = 0;
  if (!isalpha((unsigned char)text[0])) return 0;
  while (isalnum((unsigned char)text[n]) || text[n] == '_') n++;
  return n;
}

bool um_thermal_esatan_same(const char *text, size_t length, const char *word)
{
  if (strlen(word) != length) return false;
  for (size_t i = 0; i < length; i++)
    if (toupper((unsigned char)text[i]) != word[i]) return false;
  return true;
}

static const struct block {
  const char *name;
  enum um_thermal_esatan_block block;
  bool mortran;
} blocks[] = {
    {"LOCALS", UM_ESATAN_VALUES, false},        {"CONSTANTS", UM_ESATAN_VALUES, false},
    {"NODES", UM_ESATAN_NODES, false},          {"CONDUCTORS", UM_ESATAN_CONDUCTORS, false},
    {"ARRAYS", UM_ESATAN_NONE, false},          {"EVENTS", UM_ESATAN_NONE, false},
    {"SUBROUTINES", UM_ESATAN_OVER_TIME, true}, {"INITIAL", UM_ESATAN_ONCE, true},
    {"EXECUTION", UM_ESATAN_ONCE, true},        {"VARIABLES1", UM_ESATAN_OVER_TIME, true},
    {"VARIABLES2", UM_ESATAN_OVER_TIME, true},  {"OUTPUTS", UM_ESATAN_NONE, true}};

/* What follows a $: a block, a kind of values within one, or an end of the model. */
static enum um_status header(struct splitter *s)
{
  const char *word = s->at + 1;
  size_t n = um_thermal_esatan_word(word);
  bool model = um_thermal_esatan_same(word, n, "MODEL");
  if (model && s->begun)
    return um_core_fail(s->context, UM_ERR_INPUT,
                        "%s:%d: a second $MODEL; accepted: one model, without submodels", s->path,
                        s->line);
  s->begun = s->begun || model;
  s->ended = um_thermal_esatan_same(word, n, "ENDMODEL");
  if (model || s->ended) return UM_OK;
  s->text = um_thermal_esatan_same(word, n, "CHARACTER");
  if (s->text || um_thermal_esatan_same(word, n, "REAL") ||
      um_thermal_esatan_same(word, n, "INTEGER") || um_thermal_esatan_same(word, n, "CONTROL"))
    return UM_OK;
  for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++)
    if (um_thermal_esatan_same(word, n, blocks[i].name)) {
      s->block = blocks[i].block;
      s->mortran = blocks[i].mortran;
      return UM_OK;
    }
  return um_core_fail(s->context, UM_ERR_INPUT, "%s:%d: block '$%.*s'; " ACCEPTED, s->path, s->line,
                      (int)(n < 40 ? n : 40), word);
}

static enum um_status keep(struct splitter *s, const char *text, int line)
{
  if (s->block == UM_ESATAN_NONE || s->text || text[0] == '\0') return UM_OK;
  UM_TRY(um_thermal_network_grow(s->context, &s->statement, s->n, &s->room, sizeof *s->statement));
  s->statement[s->n++] = (struct um_thermal_esatan_statement){text, line, s->block};
  return UM_OK;
}

static void trim_end(char *begin, char *end)
{
  while (end > begin && isspace((unsigned char)end[-1])) end--;
  *end = '\0';
}

/* A line of Mortran. */
static enum um_status take_line(struct splitter *s)
{
  char *begin = s->at, *end = begin + strcspn(begin, "\n");
  bool more = *end == '\n';
  int line = s->line;
  s->at = end + more;
  s->line += more;
  trim_end(begin, end);
  return keep(s, begin, line);
}

/* Data up to its ';'; comments become blanks, as do ends of lines. */
static enum um_status take_data(struct splitter *s)
{
  char *begin = s->at, *c = begin;
  int line = s->line;
  bool quoted = false;
  for (; *c != '\0' && (*c != ';' || quoted); c++) {
    if (*c == '\'') quoted = !quoted;
    if (*c == '#' && !quoted)
      for (; *c != '\0' && *c != '\n'; c++) *c = ' ';
    if (*c == '\0') break;
    if (*c != '\n') continue;
    s->line++;
    if (quoted || c[1 + strspn(c + 1, " \t\r")] == '$') break;
    *c = ' ';
  }
  if (*c != ';') {
    trim_end(begin, c);
    return um_core_fail(s->context, UM_ERR_INPUT, "%s:%d: '%.40s': %s is missing", s->path, line,
                        begin, quoted ? "the quote behind it" : "the ';' behind it");
  }
  s->at = c + 1;
  trim_end(begin, c);
  return keep(s, begin, line);
}

static bool is_comment(const struct splitter *s, bool first)
{
  return *s->at == '#' ||
         (s->mortran && first && (*s->at == 'C' || *s->at == 'c' || *s->at == '*') &&
          (um_thermal_esatan_word(s->at) <= 1));
}

enum um_status um_thermal_esatan_split(struct um_context *context, const char *path, char *text,
                                       struct um_thermal_esatan_statement **statement, size_t *n)
{
  enum um_status status = UM_OK;
  struct splitter s = {.context = context, .path = path, .at = text, .line = 1};
  bool first = true; /* at the first column of a line */
  while (status == UM_OK && *s.at != '\0' && !s.ended) {
    if (*s.at == '\n') {
      s.line++;
      s.at++;
      first = true;
    } else if (isspace((unsigned char)*s.at)) {
      s.at++;
      first = false;
    } else if (is_comment(&s, first)) {
      s.at += strcspn(s.at, "\n");
    } else if (*s.at == '$') {
      status = header(&s);
      s.at += strcspn(s.at, "\n");
    } else if (s.mortran) {
      status = take_line(&s);
      first = true;
    } else {
      status = take_data(&s);
      first = false;
    }
  }
  *statement = s.statement;
  *n = s.n;
  return status;
}
