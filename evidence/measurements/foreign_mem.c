/* Data messages of CNES (CIC MEM) as key = value: a quantity over time, a row an instant, as
 * `time_utc,CONTENT (unit)` or `time_utc,CONTENT_1 (unit),CONTENT_2 (unit)`. Keys: CNES, VTS user
 * manual, CIC protocol. Rows begin with a modified Julian day and seconds of it. */
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/number.h"
#include "evidence/measurements/foreign_kind.h"
#include "evidence/measurements/foreign_line.h"
#include "orbit/time.h"

#define VALUES_MAX 256 /* values of a row */

struct message {
  struct um_compare_foreign_at at;
  bool meta, rows;
  char content[64], unit[32], scale[16];
  size_t size; /* values of a row; 0: as many as the first has */
};

/* The next word of a row, or the text between two quotation marks; NULL behind the last. */
static char *word_next(char **at)
{
  *at += strspn(*at, " \t\r");
  if (**at == '\0') return NULL;
  const char *ends = **at == '"' ? "\"" : " \t\r";
  char *word = **at == '"' ? *at + 1 : *at;
  *at = word + strcspn(word, ends);
  if (**at != '\0') *(*at)++ = '\0';
  return word;
}

/* A segment says what its rows hold; a second one has to say the same. */
static enum um_status take_text(struct message *m, const char *key, const char *value, char *to,
                                size_t room)
{
  if (strlen(value) >= room) return um_compare_foreign_refuse(&m->at, value, "a shorter text");
  if (to[0] != '\0' && strcmp(to, value) != 0)
    return um_core_fail(m->at.context, UM_ERR_INPUT,
                        "%s:%d: %s: '%s' in one segment, '%s' in another; accepted: files of one "
                        "quantity",
                        m->at.path, m->at.line, key, to, value);
  memcpy(to, value, strlen(value) + 1);
  return UM_OK;
}

static enum um_status take_key(struct message *m, const char *key, const char *value)
{
  double size;
  if (strcmp(key, "USER_DEFINED_CONTENT") == 0)
    return take_text(m, key, value, m->content, sizeof m->content);
  if (strcmp(key, "USER_DEFINED_UNIT") == 0)
    return take_text(m, key, value, m->unit, sizeof m->unit);
  if (strcmp(key, "TIME_SYSTEM") == 0)
    return um_orbit_time_scale_is_known(value)
               ? take_text(m, key, value, m->scale, sizeof m->scale)
               : um_compare_foreign_refuse(&m->at, value, "UTC, TAI, TT, GPS");
  if (strcmp(key, "USER_DEFINED_SIZE") != 0) return UM_OK;
  if (!um_core_number_parse(value, &size) || !(size >= 1.0 && size <= VALUES_MAX) ||
      size != (double)(size_t)size || (m->size != 0 && m->size != (size_t)size))
    return um_compare_foreign_refuse(&m->at, value,
                                     "values of a row, 1 to 256, the same in each segment");
  m->size = (size_t)size;
  return UM_OK;
}

static enum um_status take_row(struct message *m, char *text, FILE *csv)
{
  double day, seconds, t;
  char utc[32], *word = word_next(&text), *second = word_next(&text);
  size_t n = 0;
  if (second == NULL || !um_core_number_parse(word, &day) ||
      !um_core_number_parse(second, &seconds) ||
      !um_orbit_time_from_mjd(day, seconds, m->scale, &t))
    return um_compare_foreign_refuse(&m->at, word,
                                     "a modified Julian day and seconds of it, 57652 73862.0");
  um_orbit_time_format(t, utc);
  if (csv != NULL) fputs(utc, csv);
  for (; (word = word_next(&text)) != NULL; n++)
    if (csv != NULL) um_core_csv_put_text(csv, word, "");
  if (m->size == 0 && n <= VALUES_MAX) m->size = n;
  if (n != 0 && n == m->size) return UM_OK;
  return um_core_fail(m->at.context, UM_ERR_INPUT,
                      "%s:%d: %zu values; accepted: %zu, as USER_DEFINED_SIZE or the first row has",
                      m->at.path, m->at.line, n, m->size);
}

static enum um_status take_line(struct message *m, char *line, FILE *csv)
{
  char *text = um_compare_foreign_trimmed(line), *equals = strchr(text, '=');
  if (text[0] == '\0' || strncmp(text, "COMMENT", 7) == 0) return UM_OK;
  if (strcmp(text, "META_START") == 0) {
    m->meta = true;
    m->rows = false;
  } else if (strcmp(text, "META_STOP") == 0) {
    if (m->content[0] == '\0' || m->scale[0] == '\0')
      return um_compare_foreign_refuse(&m->at, text,
                                       "USER_DEFINED_CONTENT and TIME_SYSTEM before it");
    m->meta = false;
    m->rows = true;
  } else if (m->rows) {
    return take_row(m, text, csv);
  } else if (equals == NULL) {
    return um_compare_foreign_refuse(&m->at, text,
                                     m->meta ? "KEYWORD = value" : "META_START before rows");
  } else if (m->meta) {
    *equals = '\0';
    return take_key(m, um_compare_foreign_trimmed(text), um_compare_foreign_trimmed(equals + 1));
  }
  return UM_OK;
}

/* Names of the columns: the content, numbered where a row has several values, and its unit. */
static void put_names(const struct message *m, FILE *csv)
{
  bool has_unit = m->unit[0] != '\0' && strstr(m->unit, "n/a") == NULL;
  size_t length = strcspn(m->unit + (m->unit[0] == '['), "]");
  fputs("time_utc", csv);
  for (size_t k = 1; k <= m->size; k++) {
    char name[160], number[24] = "";
    if (m->size > 1) snprintf(number, sizeof number, "_%zu", k);
    snprintf(name, sizeof name, has_unit ? "%s%s (%.*s)" : "%s%s", m->content, number, (int)length,
             m->unit + (m->unit[0] == '['));
    um_core_csv_put_text(csv, name, "");
  }
}

/* Reads the lines of `text`, which is written into. csv: NULL, to look for names alone. */
static enum um_status read_lines(struct message *m, char *text, FILE *csv)
{
  m->at.line = 0;
  m->meta = m->rows = false;
  for (char *line; (line = um_compare_foreign_line(&m->at, &text)) != NULL;) {
    if (m->at.line % 4096 == 0) UM_TRY(um_core_stop_check(m->at.context, "a message was read"));
    if (m->at.line == 1 && csv != NULL) put_names(m, csv); /* where the version stands */
    if (m->at.line > 1) UM_TRY(take_line(m, line, csv));
    if (csv != NULL) fputc('\n', csv);
  }
  if (m->rows && m->size > 0) return UM_OK;
  return um_core_fail(m->at.context, UM_ERR_INPUT,
                      "%s:%d: no rows behind META_STOP: the file may be cut short", m->at.path,
                      m->at.line);
}

static enum um_status convert(struct um_context *context, const char *path, const char *bytes,
                              size_t length, FILE *csv)
{
  enum um_status status = UM_OK;
  struct message m = {.at = {context, path, 0}};
  char *text = NULL;
  UM_TRY(um_core_allocate(context, length + 1, 1, &text));
  memcpy(text, bytes, length);
  UM_CHECK(read_lines(&m, text, NULL));
  memcpy(text, bytes, length);
  UM_CHECK(read_lines(&m, text, csv));
done:
  um_core_free(context, text);
  return status;
}

static bool is(const char *bytes, size_t length)
{
  static const char mark[] = "CIC_MEM_VERS";
  return length > sizeof mark && strncmp(bytes, mark, sizeof mark - 1) == 0;
}

const struct um_compare_foreign_kind um_compare_foreign_mem = {is, convert};
