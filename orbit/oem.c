/* Orbit ephemeris messages as key = value: OEM (CCSDS 502.0-B-3, section 5) and that of CNES (CIC),
 * whose rows begin with a modified Julian day and seconds of it. Segments follow one another; where
 * one begins at the last row of the one before, that row is taken once. EME2000 differs from GCRS
 * by the bias of its frame,
 *
 *   r_GCRS = B^T r_EME2000   (IERS Conventions 2010, 5.6; 0.023 arcsec, 0.8 m of a low orbit). */
#include <erfa.h>
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/number.h"
#include "orbit/time.h"
#include "orbit/trajectory_impl.h"

#define TOKENS 12

/* Rows of a segment; lines between COVARIANCE_START and COVARIANCE_STOP are none. */
enum place { HEADER, META, ROWS, COVARIANCE };

struct reader {
  struct um_context *context;
  const char *name;
  int line;
  enum place place;
  bool has_days;  /* CIC: a time is two numbers */
  bool is_biased; /* of the segment: EME2000 */
  char scale[8];  /* of the segment */
  size_t segments, room;
  bool begins;       /* no row of the segment was read */
  double bias[3][3]; /* GCRS to EME2000 */
  struct um_orbit_table *table;
};

bool um_orbit_oem_is(const char *text)
{
  if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) text += 3;
  text += strspn(text, " \t\r\n");
  return strncmp(text, "CCSDS_OEM_VERS", 14) == 0 || strncmp(text, "CIC_OEM_VERS", 12) == 0;
}

static enum um_status refuse(const struct reader *r, const char *key, const char *value,
                             const char *accepted)
{
  return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: %s: '%.40s'; accepted: %s", r->name,
                      r->line, key, value, accepted);
}

/* --- what a segment says of itself ------------------------------------------------------------ */

static enum um_status take_key(struct reader *r, const char *key, const char *value)
{
  if (strcmp(key, "CENTER_NAME") == 0 && strcmp(value, "EARTH") != 0)
    return refuse(r, key, value, "EARTH");
  if (strcmp(key, "REF_FRAME") == 0) {
    r->is_biased = strcmp(value, "EME2000") == 0;
    if (!r->is_biased && strcmp(value, "GCRF") != 0 && strcmp(value, "ICRF") != 0)
      return refuse(r, key, value, "GCRF, ICRF, EME2000");
  }
  if (strcmp(key, "TIME_SYSTEM") == 0) {
    if (!um_orbit_time_scale_is_known(value)) return refuse(r, key, value, "UTC, TAI, TT, GPS");
    memcpy(r->scale, value, strlen(value) + 1);
  }
  return UM_OK;
}

/* --- rows ------------------------------------------------------------------------------------- */

static enum um_status row_time(const struct reader *r, char *const *token, double *t)
{
  double day, seconds;
  char accepted[200];
  if (!r->has_days)
    return um_orbit_time_parse_message(token[0], r->scale, t, accepted, sizeof accepted)
               ? UM_OK
               : refuse(r, "time", token[0], accepted);
  if (um_core_number_parse(token[0], &day) && um_core_number_parse(token[1], &seconds) &&
      um_orbit_time_from_mjd(day, seconds, r->scale, t))
    return UM_OK;
  return refuse(r, "time", token[0], "a modified Julian day and seconds of it, 57652 73862.0");
}

static struct um_vec3 unbiased(const struct reader *r, const double x[3])
{
  double out[3] = {x[0], x[1], x[2]};
  if (r->is_biased)
    for (int k = 0; k < 3; k++)
      out[k] = r->bias[0][k] * x[0] + r->bias[1][k] * x[1] + r->bias[2][k] * x[2];
  return um_vec3(1e3 * out[0], 1e3 * out[1], 1e3 * out[2]);
}

static enum um_status put_row(struct reader *r, double t, struct um_vec3 at, struct um_vec3 v)
{
  struct um_orbit_table *table = r->table;
  if (table->n == r->room) {
    size_t room = r->room == 0 ? 256 : 2 * r->room;
    UM_TRY(um_core_reallocate(r->context, room, sizeof *table->t, (void **)&table->t));
    UM_TRY(um_core_reallocate(r->context, room, sizeof *table->r, (void **)&table->r));
    UM_TRY(um_core_reallocate(r->context, room, sizeof *table->v, (void **)&table->v));
    r->room = room;
  }
  table->t[table->n] = t;
  table->r[table->n] = at;
  table->v[table->n++] = v;
  return UM_OK;
}

/* Time, place [km], velocity [km/s]; accelerations behind them are not needed. */
static enum um_status take_row(struct reader *r, char *const *token, size_t count)
{
  size_t first = r->has_days ? 2 : 1;
  double x[6], t;
  if (count != first + 6 && count != first + 9)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: %zu fields; accepted: a time, 3 of the place, 3 of the velocity",
                        r->name, r->line, count);
  UM_TRY(row_time(r, token, &t));
  for (size_t k = 0; k < 6; k++)
    if (!um_core_number_parse(token[first + k], &x[k]))
      return refuse(r, k < 3 ? "place" : "velocity", token[first + k], "a number");
  struct um_vec3 at = unbiased(r, x), v = unbiased(r, x + 3);
  double distance = um_vec3_norm(at);
  if (!(distance >= UM_ORBIT_NEAREST && distance <= UM_ORBIT_FARTHEST))
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: the position is %g km from the geocentre; accepted: %g to %g km",
                        r->name, r->line, 1e-3 * distance, 1e-3 * UM_ORBIT_NEAREST,
                        1e-3 * UM_ORBIT_FARTHEST);
  if (!(um_vec3_norm(v) < UM_LIGHT_SPEED))
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: the speed is %g km/s; accepted: less than light's", r->name,
                        r->line, 1e-3 * um_vec3_norm(v));
  double last = r->table->n > 0 ? r->table->t[r->table->n - 1] : -INFINITY;
  bool again = r->begins && t == last;
  r->begins = false;
  if (again) return UM_OK;
  if (!(t > last))
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: %s is not after the row before it; ascending times are accepted",
                        r->name, r->line, token[first - 1]);
  return put_row(r, t, at, v);
}

/* --- lines ------------------------------------------------------------------------------------ */

/* Words of a line, which is written into; more than fit are not told apart. */
static size_t split(char *line, char *token[TOKENS])
{
  size_t n = 0;
  while (n < TOKENS) {
    line += strspn(line, " \t\r");
    if (*line == '\0') break;
    token[n++] = line;
    line += strcspn(line, " \t\r");
    if (*line != '\0') *line++ = '\0';
  }
  return n;
}

static enum um_status begin_segment(struct reader *r)
{
  r->place = META;
  r->scale[0] = '\0';
  r->is_biased = false;
  r->segments++;
  return UM_OK;
}

static enum um_status take_line(struct reader *r, char *line)
{
  char *token[TOKENS];
  size_t count = split(line, token);
  if (count == 0 || strcmp(token[0], "COMMENT") == 0) return UM_OK;
  if (strcmp(token[0], "META_START") == 0) return begin_segment(r);
  if (strcmp(token[0], "META_STOP") == 0) {
    r->place = ROWS;
    r->begins = true;
    if (r->scale[0] != '\0') return UM_OK;
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: the segment has no TIME_SYSTEM", r->name,
                        r->line);
  }
  if (strcmp(token[0], "COVARIANCE_START") == 0) r->place = COVARIANCE;
  if (r->place == ROWS) return take_row(r, token, count);
  if (strcmp(token[0], "COVARIANCE_STOP") == 0) r->place = ROWS;
  if (r->place != META) return UM_OK;
  if (count < 3 || strcmp(token[1], "=") != 0)
    return refuse(r, "a line between META_START and META_STOP", token[0], "KEYWORD = value");
  return take_key(r, token[0], token[2]);
}

enum um_status um_orbit_oem_read(struct um_context *context, const char *name, char *text,
                                 struct um_orbit_table *table)
{
  double precession[3][3], both[3][3];
  struct reader r = {.context = context, .name = name, .table = table};
  eraBp06(2451545.0, 0.0, r.bias, precession, both);
  if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) text += 3;
  r.has_days = strncmp(text + strspn(text, " \t\r\n"), "CIC_", 4) == 0;
  for (char *at = text, *next; at != NULL; at = next) {
    char *end = at + strcspn(at, "\n");
    next = *end != '\0' ? end + 1 : NULL;
    *end = '\0';
    r.line++;
    if (r.line % 4096 == 0) UM_TRY(um_core_stop_check(context, "an ephemeris was read"));
    UM_TRY(take_line(&r, at));
  }
  if (table->n >= 2) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: %zu rows, at least 2 are accepted", name,
                      table->n);
}
