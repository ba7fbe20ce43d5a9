/* Ephemeris and attitude files of STK as messages of CNES:
 *
 *   stk.v.11.0
 *   BEGIN Ephemeris                      BEGIN Attitude
 *   ScenarioEpoch 1 Jun 2016 12:00:00.0  (UTC; rows count seconds from it)
 *   CoordinateSystem J2000               CoordinateAxes J2000
 *   DistanceUnit Kilometers              (metres where it is not there)
 *   EphemerisTimePosVel                  AttitudeTimeQuaternions
 *   0.0 x y z vx vy vz                   0.0 q1 q2 q3 q4
 *   END Ephemeris                        END Attitude */
#include "orbit/stk_impl.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/core/csv.h"
#include "base/core/number.h"
#include "orbit/time.h"

#define WORDS 12
#define DAY   86400.0 /* [s] */

/* What a file says before its rows. */
struct stk {
  struct um_context *context;
  const char *name;
  enum um_orbit_stk_kind kind;
  int line;
  double epoch;        /* t_tai [s]; NaN: not said */
  double unit;         /* of lengths [km] */
  const char *frame;   /* as messages call it; NULL: not said */
  bool rows, was_rows; /* within them, passed them */
};

static enum um_status refuse(const struct stk *s, const char *what, const char *accepted)
{
  return um_core_fail(s->context, UM_ERR_INPUT, "%s:%d: '%.60s'; accepted: %s", s->name, s->line,
                      what, accepted);
}

/* "1 Jun 2016 12:00:00.000" as "2016-06-01T12:00:00.000". */
static bool epoch_of(const char *text, double *t_tai)
{
  static const char months[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
  char iso[80], accepted[200], *end;
  long day = strtol(text, &end, 10), year;
  while (*end == ' ') end++;
  int month = 0;
  while (month < 12 && strncasecmp(end, months + 3 * month, 3) != 0) month++;
  if (month == 12 || day < 1 || day > 31) return false;
  year = strtol(end + 3, &end, 10);
  while (*end == ' ') end++;
  if (year < 1900 || year > 2200 || strlen(end) > 30) return false;
  snprintf(iso, sizeof iso, "%04ld-%02d-%02ldT%s", year, month + 1, day, end);
  return um_orbit_time_parse_message(iso, "UTC", t_tai, accepted, sizeof accepted);
}

static bool is(const char *word, const char *keyword) { return strcasecmp(word, keyword) == 0; }

static enum um_status take_frame(struct stk *s, const char *value)
{
  /* as STK calls it, and as messages do */
  static const char *const names[][2] = {{"J2000", "EME2000"},  {"ICRF", "ICRF"},
                                         {"Fixed", "ITRF"},     {"TEMEOfDate", "TEME"},
                                         {"TrueOfDate", "TOD"}, {"MeanOfDate", "MOD"}};
  s->frame = NULL;
  for (size_t k = 0; k < sizeof names / sizeof *names; k++)
    if (is(value, names[k][0])) s->frame = names[k][1];
  if (s->frame != NULL) return UM_OK;
  return refuse(s, value, "J2000, ICRF, Fixed, TEMEOfDate, TrueOfDate, MeanOfDate");
}

/* A line before the rows: its first word, and the rest. */
static enum um_status take_keyword(struct stk *s, const char *word, const char *rest)
{
  bool places = s->kind == UM_ORBIT_STK_EPHEMERIS;
  const char *rows = places ? "EphemerisTimePosVel" : "AttitudeTimeQuaternions";
  if (is(word, "ScenarioEpoch") && !epoch_of(rest, &s->epoch))
    return refuse(s, rest, "UTC as 1 Jun 2016 12:00:00.000");
  if (is(word, places ? "CoordinateSystem" : "CoordinateAxes")) return take_frame(s, rest);
  if (is(word, "CentralBody") && !is(rest, "Earth")) return refuse(s, rest, "Earth");
  if (is(word, "DistanceUnit")) {
    if (!is(rest, "Meters") && !is(rest, "Kilometers"))
      return refuse(s, rest, "Meters, Kilometers");
    s->unit = is(rest, "Meters") ? 1e-3 : 1.0;
  }
  if (is(word, "BEGIN") && !is(rest, places ? "Ephemeris" : "Attitude"))
    return refuse(s, rest,
                  places ? "Ephemeris; an attitude is for attitude.table"
                         : "Attitude; an ephemeris is for orbit.table");
  if (strncasecmp(word, places ? "EphemerisTime" : "AttitudeTime",
                  strlen(places ? "EphemerisTime" : "AttitudeTime")) != 0)
    return UM_OK;
  if (!is(word, rows)) return refuse(s, word, rows);
  if (isnan(s->epoch)) return refuse(s, word, "ScenarioEpoch before it");
  if (s->frame == NULL)
    return refuse(s, word, places ? "CoordinateSystem before it" : "CoordinateAxes before it");
  s->rows = true;
  return UM_OK;
}

/* Seconds and numbers as a day, seconds of it and numbers. */
static enum um_status put_row(const struct stk *s, char *line, FILE *out)
{
  size_t n = 0, wanted = s->kind == UM_ORBIT_STK_EPHEMERIS ? 7 : 5;
  double number[WORDS];
  for (char *save, *word = strtok_r(line, " \t\r", &save); word != NULL;
       word = strtok_r(NULL, " \t\r", &save)) {
    if (n == wanted || !um_core_number_parse(word, &number[n]))
      return refuse(s, word,
                    wanted == 7 ? "seconds, 3 of the place, 3 of the velocity"
                                : "seconds, 4 of a quaternion");
    n++;
  }
  if (n == 0) return UM_OK;
  if (n < wanted)
    return refuse(s, line,
                  wanted == 7 ? "seconds, 3 of the place, 3 of the velocity"
                              : "seconds, 4 of a quaternion");
  /* TAI counts from 2000-01-01T12:00, MJD 51544.5 */
  double since = s->epoch + number[0] + 0.5 * DAY, day = floor((since + 1e-9) / DAY);
  fprintf(out, "%.0f %.9f", 51544.0 + day, fmax(0.0, since - DAY * day));
  for (size_t k = 1; k < n; k++) {
    char text[32];
    um_core_number_text(wanted == 7 ? s->unit * number[k] : number[k], text);
    fprintf(out, " %s", text);
  }
  return UM_OK;
}

static enum um_status take_line(struct stk *s, char *line, FILE *out)
{
  char *begin = line + strspn(line, " \t\r"), *end = begin + strlen(begin);
  while (end > begin && isspace((unsigned char)end[-1])) *--end = '\0';
  size_t n = strcspn(begin, " \t");
  char *rest = begin + n + strspn(begin + n, " \t");
  if (*begin == '\0' || *begin == '#' || s->was_rows) return UM_OK;
  if (strncasecmp(begin, "END", 3) == 0 && (begin[3] == '\0' || begin[3] == ' ')) {
    s->was_rows = s->rows;
    s->rows = false;
    return UM_OK;
  }
  if (s->rows) return put_row(s, begin, out);
  begin[n] = '\0';
  return take_keyword(s, begin, rest);
}

/* Lines of the file as lines of a message, the body of which is made before its head. */
static enum um_status body(struct stk *s, char *text, FILE *out)
{
  for (char *at = text, *next; at != NULL; at = next) {
    char *end = at + strcspn(at, "\n");
    next = *end != '\0' ? end + 1 : NULL;
    *end = '\0';
    if (++s->line % 4096 == 0) UM_TRY(um_core_stop_check(s->context, "a table was read"));
    UM_TRY(take_line(s, at, out));
    fputc('\n', out);
  }
  if (s->was_rows) return UM_OK;
  return um_core_fail(s->context, UM_ERR_INPUT,
                      "%s:%d: no END behind rows: the file may be cut short", s->name, s->line);
}

bool um_orbit_stk_is(const char *text)
{
  text += strspn(text, " \t\r\n");
  return strncasecmp(text, "stk.v.", 6) == 0;
}

enum um_status um_orbit_stk_message(struct um_context *context, const char *name, const char *text,
                                    enum um_orbit_stk_kind kind, char **out, int *before)
{
  enum um_status status;
  struct stk s = {.context = context, .name = name, .kind = kind, .epoch = NAN, .unit = 1e-3};
  char *copy = NULL, *rows = NULL;
  size_t n = 0;
  *out = NULL;
  UM_TRY(um_core_strdup(context, text, &copy));
  FILE *file = open_memstream(&rows, &n);
  if (file == NULL)
    status = um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  else
    status = body(&s, copy, file);
  if (file != NULL && fclose(file) != 0 && status == UM_OK)
    status = um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  UM_CHECK(status);
  const char *frame = s.frame != NULL ? s.frame : "";
  if (kind == UM_ORBIT_STK_EPHEMERIS) {
    *before = 6;
    UM_CHECK(um_core_asprintf(context, out,
                              "CIC_OEM_VERS = 1.0\nMETA_START\nCENTER_NAME = EARTH\nREF_FRAME = "
                              "%s\nTIME_SYSTEM = TAI\nMETA_STOP\n%s",
                              frame, rows));
  } else {
    *before = 9;
    UM_CHECK(um_core_asprintf(context, out,
                              "CIC_AEM_VERS = 1.0\nMETA_START\nREF_FRAME_A = %s\nREF_FRAME_B = "
                              "SC_BODY_1\nATTITUDE_DIR = A2B\nATTITUDE_TYPE = QUATERNION\n"
                              "QUATERNION_TYPE = LAST\nTIME_SYSTEM = TAI\nMETA_STOP\n%s",
                              frame, rows));
  }
done:
  free(rows); /* of the C library */
  um_core_free(context, copy);
  return status;
}
