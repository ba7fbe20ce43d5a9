/* Messages of CCSDS (502.0-B, 504.0-B) and of CNES (CIC) as key = value: lines, segments, times.
 * Rows of CIC begin with a modified Julian day and seconds of it. Other ways to write them become
 * these lines first. */
#include "orbit/message_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/number.h"
#include "orbit/time.h"

static const char *skip_blanks(const char *text)
{
  if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) text += 3;
  return text + strspn(text, " \t\r\n");
}

/* Does a text begin as key = value of that kind, "OEM", does? */
static bool is_pairs(const char *text, const char *kind)
{
  if (strncmp(text, "CCSDS_", 6) == 0)
    text += 6;
  else if (strncmp(text, "CIC_", 4) == 0)
    text += 4;
  else
    return false;
  return strncmp(text, kind, strlen(kind)) == 0 && strncmp(text + strlen(kind), "_VERS", 5) == 0;
}

enum um_status um_orbit_message_refuse(const struct um_orbit_message *m, const char *key,
                                       const char *value, const char *accepted)
{
  return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: %s: '%.40s'; accepted: %s", m->name,
                      m->line, key, value, accepted);
}

enum um_status um_orbit_message_blame(const struct um_orbit_message *m, enum um_status status)
{
  if (status != UM_OK) um_core_message_prefix(m->context, "%s:%d", m->name, m->line);
  return status;
}

/* --- rows ------------------------------------------------------------------------------------- */

static enum um_status row_time(const struct um_orbit_message *m, char *const *word, double *t)
{
  double day, seconds;
  char accepted[200];
  if (!m->has_days)
    return um_orbit_time_parse_message(word[0], m->scale, t, accepted, sizeof accepted)
               ? UM_OK
               : um_orbit_message_refuse(m, "time", word[0], accepted);
  if (um_core_number_parse(word[0], &day) && um_core_number_parse(word[1], &seconds) &&
      um_orbit_time_from_mjd(day, seconds, m->scale, t))
    return UM_OK;
  return um_orbit_message_refuse(m, "time", word[0],
                                 "a modified Julian day and seconds of it, 57652 73862.0");
}

static enum um_status take_row(struct um_orbit_message *m, char *const *word, size_t count)
{
  const struct um_orbit_message_calls *calls = m->calls;
  size_t first = m->has_days ? 2 : 1;
  double number[UM_ORBIT_MESSAGE_WORDS], t;
  if (count != first + calls->least && count != first + calls->most)
    return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: %zu fields; accepted: %s", m->name,
                        m->line, count, calls->row_is);
  UM_TRY(row_time(m, word, &t));
  for (size_t k = first; k < count; k++)
    if (!um_core_number_parse(word[k], &number[k - first]))
      return um_orbit_message_refuse(m, "a row", word[k], "a number");
  bool again = m->begins && t == m->last;
  m->begins = false;
  if (again) return UM_OK;
  if (!(t > m->last))
    return um_core_fail(m->context, UM_ERR_INPUT,
                        "%s:%d: %s is not after the row before it; ascending times are accepted",
                        m->name, m->line, word[first - 1]);
  m->last = t;
  m->rows++;
  return calls->row(m, m->self, t, number, count - first);
}

/* --- lines ------------------------------------------------------------------------------------ */

/* Blanks off both ends of [text, end), which is ended there. */
static char *trim(char *text, char *end)
{
  while (text < end && strchr(" \t\r", *text) != NULL) text++;
  while (end > text && strchr(" \t\r", end[-1]) != NULL) end--;
  *end = '\0';
  return text;
}

bool um_orbit_message_pair(char *line, char **key, char **value)
{
  char *equals = strchr(line, '=');
  if (equals == NULL) return false;
  *value = trim(equals + 1, equals + 1 + strlen(equals + 1));
  *key = trim(line, equals);
  return true;
}

/* Words of a line, which is written into; more than fit are not told apart. */
static size_t split(char *line, char *word[UM_ORBIT_MESSAGE_WORDS])
{
  size_t n = 0;
  while (n < UM_ORBIT_MESSAGE_WORDS) {
    line += strspn(line, " \t\r");
    if (*line == '\0') break;
    word[n++] = line;
    line += strcspn(line, " \t\r");
    if (*line != '\0') *line++ = '\0';
  }
  return n;
}

static enum um_status take_key(struct um_orbit_message *m, const char *key, const char *value)
{
  if (strcmp(key, "TIME_SYSTEM") != 0) return m->calls->key(m, m->self, key, value);
  if (!um_orbit_time_scale_is_known(value))
    return um_orbit_message_refuse(m, key, value, "UTC, TAI, TT, GPS");
  memcpy(m->scale, value, strlen(value) + 1);
  return UM_OK;
}

static enum um_status end_meta(struct um_orbit_message *m)
{
  m->place = UM_ORBIT_ROWS;
  m->begins = true;
  if (m->scale[0] == '\0')
    return um_core_fail(m->context, UM_ERR_INPUT, "%s:%d: the segment has no TIME_SYSTEM", m->name,
                        m->line);
  return m->calls->ready != NULL ? m->calls->ready(m, m->self) : UM_OK;
}

static enum um_status take_line(struct um_orbit_message *m, char *line)
{
  char *word[UM_ORBIT_MESSAGE_WORDS], *key, *value;
  bool is_pair = m->place < UM_ORBIT_ROWS && um_orbit_message_pair(line, &key, &value);
  if (is_pair && strncmp(key, "COMMENT", 7) != 0) {
    if (m->place == UM_ORBIT_META) return take_key(m, key, value);
    if (strstr(key, "_VERS") != NULL) m->version = value[0];
    return UM_OK;
  }
  size_t count = split(line, word);
  if (count == 0 || strcmp(word[0], "COMMENT") == 0 || strcmp(word[0], "DATA_START") == 0 ||
      strcmp(word[0], "DATA_STOP") == 0)
    return UM_OK;
  if (strcmp(word[0], "META_START") == 0) {
    m->place = UM_ORBIT_META;
    m->scale[0] = '\0';
    if (m->calls->begin != NULL) m->calls->begin(m->self);
    return UM_OK;
  }
  if (strcmp(word[0], "META_STOP") == 0) return end_meta(m);
  if (strcmp(word[0], "COVARIANCE_START") == 0) m->place = UM_ORBIT_COVARIANCE;
  if (m->place == UM_ORBIT_ROWS) return take_row(m, word, count);
  if (strcmp(word[0], "COVARIANCE_STOP") == 0) m->place = UM_ORBIT_ROWS;
  if (m->place != UM_ORBIT_META) return UM_OK;
  return um_orbit_message_refuse(m, "a line between META_START and META_STOP", word[0],
                                 "KEYWORD = value");
}

/* --- texts ------------------------------------------------------------------------------------ */

static enum um_status read_lines(struct um_orbit_message *m, char *text)
{
  m->has_days = strncmp(text, "CIC_", 4) == 0;
  for (char *at = text, *next; at != NULL; at = next) {
    char *end = at + strcspn(at, "\n");
    next = *end != '\0' ? end + 1 : NULL;
    *end = '\0';
    m->line++;
    if (m->line % 4096 == 0) UM_TRY(um_core_stop_check(m->context, "a message was read"));
    UM_TRY(take_line(m, at));
  }
  return UM_OK;
}

/* A line of a message in XML. Each message of a file begins anew. */
static enum um_status take_xml_line(void *self, int line, char *text)
{
  struct um_orbit_message *m = self;
  m->line = line;
  if (strncmp(text, "CCSDS_", 6) == 0) m->place = UM_ORBIT_HEADER;
  return take_line(m, text);
}

static enum um_status read_stk(struct um_orbit_message *m, const char *text)
{
  char *lines = NULL;
  int before = 0;
  UM_TRY(um_orbit_stk_message(m->context, m->name, text, m->calls->stk, &lines, &before));
  m->line = -before;
  enum um_status status = read_lines(m, lines);
  um_core_free(m->context, lines);
  return status;
}

enum um_status um_orbit_message_read(struct um_orbit_message *m, char *text, size_t length,
                                     bool *is)
{
  char *first = text + (skip_blanks(text) - text);
  m->last = -INFINITY;
  *is = strlen(text) == length &&
        (is_pairs(first, m->calls->kind) || first[0] == '<' || um_orbit_stk_is(first));
  if (!*is) return UM_OK;
  if (first[0] == '<')
    UM_TRY(um_orbit_ndm_read(m->context, m->name, text, length, &m->calls->form, take_xml_line, m));
  else if (um_orbit_stk_is(first))
    UM_TRY(read_stk(m, text));
  else
    UM_TRY(read_lines(m, text));
  if (m->rows >= 2) return UM_OK;
  return um_core_fail(m->context, UM_ERR_INPUT, "%s: %zu rows, at least 2 are accepted", m->name,
                      m->rows);
}
