/* Tracking data messages (TDM, CCSDS 503.0-B) as key = value or XML: what they say of magnitudes, a
 * row each, `time_utc,track,MAG`. A segment is a track. Angles, ranges and the rest are passed
 * over. */
#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/number.h"
#include "evidence/measurements/foreign_kind.h"
#include "evidence/measurements/foreign_line.h"
#include "orbit/ndm.h"
#include "orbit/time.h"

struct reader {
  struct um_compare_foreign_at at;
  FILE *csv;
  int segment;
  int written; /* line of the table; in XML */
  bool meta, data;
  size_t magnitudes;
  char scale[16];
};

/* "MAG = 2016-09-21T20:33:00 7.5": the text behind the '='. */
static enum um_status magnitude(struct reader *r, char *value)
{
  char accepted[200], utc[32], number[32];
  char *space = value + strcspn(value, " \t");
  double t, magnitude;
  if (*space == '\0') return um_compare_foreign_refuse(&r->at, value, "a time and a magnitude");
  *space = '\0';
  if (!um_orbit_time_parse_message(value, r->scale, &t, accepted, sizeof accepted))
    return um_compare_foreign_refuse(&r->at, value, accepted);
  const char *text = um_compare_foreign_trimmed(space + 1);
  if (!um_core_number_parse(text, &magnitude))
    return um_compare_foreign_refuse(&r->at, text, "a magnitude");
  um_orbit_time_format(t, utc);
  um_core_number_text(magnitude, number);
  fprintf(r->csv, "%s,%d,%s", utc, r->segment, number);
  r->magnitudes++;
  return UM_OK;
}

static enum um_status take_pair(struct reader *r, const char *key, char *value)
{
  if (r->meta && strcmp(key, "TIME_SYSTEM") == 0) {
    if (!um_orbit_time_scale_is_known(value))
      return um_compare_foreign_refuse(&r->at, value, "UTC, TAI, TT, GPS");
    snprintf(r->scale, sizeof r->scale, "%s", value);
  }
  return r->data && strcmp(key, "MAG") == 0 ? magnitude(r, value) : UM_OK;
}

static enum um_status take_line(struct reader *r, char *line)
{
  char *text = um_compare_foreign_trimmed(line), *equals = strchr(text, '=');
  if (strcmp(text, "META_START") == 0) {
    r->segment++;
    r->meta = true;
    r->scale[0] = '\0';
  } else if (strcmp(text, "META_STOP") == 0) {
    r->meta = false;
    if (r->scale[0] == '\0')
      return um_compare_foreign_refuse(&r->at, text,
                                       "TIME_SYSTEM before it, one of UTC, TAI, TT, GPS");
  } else if (strcmp(text, "DATA_START") == 0 || strcmp(text, "DATA_STOP") == 0) {
    r->data = text[6] == 'T' && text[7] == 'A';
    if (r->data && r->segment == 0)
      return um_compare_foreign_refuse(&r->at, text, "META_START before it");
  } else if (text[0] != '\0' && strncmp(text, "COMMENT", 7) != 0) {
    if (equals == NULL) return um_compare_foreign_refuse(&r->at, text, "KEYWORD = value");
    *equals = '\0';
    return take_pair(r, um_compare_foreign_trimmed(text), um_compare_foreign_trimmed(equals + 1));
  }
  return UM_OK;
}

static enum um_status read_lines(struct reader *r, char *text)
{
  for (char *line; (line = um_compare_foreign_line(&r->at, &text)) != NULL;) {
    if (r->at.line > 1) UM_TRY(take_line(r, line)); /* behind the version */
    fputc('\n', r->csv);
  }
  if (!r->data) return UM_OK;
  return um_core_fail(r->at.context, UM_ERR_INPUT,
                      "%s:%d: DATA_STOP is missing: the file may be cut short", r->at.path,
                      r->at.line);
}

/* A line of a message in XML: its row stands in that line of the table where there is room. */
static enum um_status take_xml_line(void *self, int line, char *text)
{
  struct reader *r = self;
  size_t before = r->magnitudes;
  r->at.line = line;
  for (; r->written < line; r->written++) fputc('\n', r->csv);
  UM_TRY(take_line(r, text));
  if (r->magnitudes == before) return UM_OK;
  fputc('\n', r->csv);
  r->written++;
  return UM_OK;
}

static bool is_xml(const char *bytes) { return um_orbit_ndm_is(bytes, "tdm"); }

static enum um_status convert(struct um_context *context, const char *path, const char *bytes,
                              size_t length, FILE *csv)
{
  static const struct um_orbit_ndm_form form = {.message = "tdm", .row = "observation"};
  enum um_status status;
  struct reader r = {.at = {context, path, 0}, .csv = csv, .written = 2};
  char *text = NULL;
  UM_TRY(um_core_allocate(context, length + 1, 1, &text));
  memcpy(text, bytes, length);
  fputs("time_utc,track,MAG", csv);
  if (is_xml(text)) {
    fputc('\n', csv);
    status = um_orbit_ndm_read(context, path, text, length, &form, take_xml_line, &r);
  } else {
    status = read_lines(&r, text);
  }
  if (status == UM_OK && r.magnitudes == 0)
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: this TDM has no magnitudes; accepted: MAG rows, of which "
                          "measurements are made",
                          path);
  um_core_free(context, text);
  return status;
}

static bool is(const char *bytes, size_t length)
{
  static const char mark[] = "CCSDS_TDM_VERS";
  return (length > sizeof mark && strncmp(bytes, mark, sizeof mark - 1) == 0) || is_xml(bytes);
}

const struct um_compare_foreign_kind um_compare_foreign_tdm = {is, convert};
