/* Earth orientation: constants, or an IERS finals2000A table in fixed columns.
 *
 * Columns (readme.finals2000A): 8-15 MJD (UTC), 19-27 xp ["], 38-46 yp ["], 59-68 UT1-UTC [s], all
 * of Bulletin A; rows whose values are still blank end the table. Between rows pole and UT1-TAI are
 * linear, so that the step of UT1-UTC at a leap second does no harm. */
#include "orbit/finals.h"

#include <erfa.h>
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/interpolation.h"
#include "orbit/time.h"

struct um_orbit_finals {
  struct um_context *context; /* owns the memory */
  size_t n;
  double *t;       /* t_tai [s], ascending, shape [n] */
  double *ut1_tai; /* [s], shape [n] */
  double *xp, *yp; /* [rad], shape [n] */
};

struct finals_row {
  double mjd, xp, yp, ut1_utc; /* [d], ["], ["], [s] */
};

enum field_state { FIELD_BLANK, FIELD_GOOD, FIELD_BAD };

/* The number in columns first..last (1-based) of a line of `length` characters. */
static enum field_state column_read(const char *line, size_t length, size_t first, size_t last,
                                    double *value)
{
  char text[16];
  size_t n = 0;
  for (size_t i = first - 1; i < last && i < length; i++)
    if (line[i] != ' ') text[n++] = line[i];
  text[n] = '\0';
  if (n == 0) return FIELD_BLANK;
  return um_core_number_parse(text, value) ? FIELD_GOOD : FIELD_BAD;
}

/* One line; *blank is set for a row without orientation values. */
static enum um_status row_read(struct um_context *context, const char *path, int number,
                               const char *line, size_t length, struct finals_row *row, bool *blank)
{
  static const struct {
    const char *name;
    size_t first, last;
  } column[4] = {{"MJD", 8, 15}, {"xp", 19, 27}, {"yp", 38, 46}, {"UT1-UTC", 59, 68}};
  double value[4];
  *blank = false;
  for (size_t k = 0; k < 4; k++) {
    enum field_state state = column_read(line, length, column[k].first, column[k].last, &value[k]);
    if (state == FIELD_BLANK && k > 0) {
      *blank = true;
      return UM_OK;
    }
    if (state != FIELD_GOOD)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s:%d: columns %zu-%zu (%s): no number there; the fixed columns of an "
                          "IERS finals2000A file are accepted",
                          path, number, column[k].first, column[k].last, column[k].name);
  }
  *row = (struct finals_row){value[0], value[1], value[2], value[3]};
  return UM_OK;
}

static enum um_status row_store(struct um_context *context, const char *path, int number,
                                const struct finals_row *row, struct um_orbit_finals *finals)
{
  size_t i = finals->n;
  if (!(fabs(row->xp) < 2.0 && fabs(row->yp) < 2.0 && fabs(row->ut1_utc) < 1.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s:%d: xp %g\", yp %g\", UT1-UTC %g s; poles below 2\" and UT1-UTC below "
                        "1 s are accepted",
                        path, number, row->xp, row->yp, row->ut1_utc);
  finals->t[i] = um_orbit_time_from_utc_jd(2400000.5, row->mjd);
  if (i > 0 && !(finals->t[i] > finals->t[i - 1]))
    return um_core_fail(context, UM_ERR_INPUT, "%s:%d: MJD %.2f does not come after the row before",
                        path, number, row->mjd);
  /* UT1 - TAI = (UT1 - UTC) + (UTC - TAI) */
  double tai_utc = finals->t[i] - (row->mjd - 51544.5) * 86400.0; /* [s] */
  finals->ut1_tai[i] = row->ut1_utc - tai_utc;
  finals->xp[i] = row->xp * UM_ARCSEC;
  finals->yp[i] = row->yp * UM_ARCSEC;
  finals->n++;
  return UM_OK;
}

static enum um_status rows_read(struct um_context *context, const char *path, const char *text,
                                struct um_orbit_finals *finals)
{
  int number = 1;
  for (const char *line = text; *line; number++) {
    size_t length = strcspn(line, "\r\n");
    bool blank = length == 0;
    struct finals_row row = {0};
    if (!blank) UM_TRY(row_read(context, path, number, line, length, &row, &blank));
    if (!blank) UM_TRY(row_store(context, path, number, &row, finals));
    line += strcspn(line, "\n");
    if (*line) line++;
  }
  if (finals->n < 2)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: %zu rows with Earth orientation; an IERS finals2000A file of at least "
                        "2 is accepted",
                        path, finals->n);
  return UM_OK;
}

enum um_status um_orbit_finals_read(struct um_context *context, const char *path,
                                    struct um_orbit_finals **out)
{
  enum um_status status;
  struct um_orbit_finals *finals = NULL;
  char *text = NULL;
  size_t length, lines = 1;
  *out = NULL;
  UM_CHECK(um_core_file_read(context, path, (size_t)64 << 20, &text, &length));
  for (size_t i = 0; i < length; i++) lines += text[i] == '\n';
  UM_CHECK(um_core_allocate(context, 1, sizeof *finals, &finals));
  finals->context = context;
  UM_CHECK(um_core_allocate(context, lines, sizeof(double), &finals->t));
  UM_CHECK(um_core_allocate(context, lines, sizeof(double), &finals->ut1_tai));
  UM_CHECK(um_core_allocate(context, lines, sizeof(double), &finals->xp));
  UM_CHECK(um_core_allocate(context, lines, sizeof(double), &finals->yp));
  UM_CHECK(rows_read(context, path, text, finals));
done:
  um_core_free(context, text);
  if (status != UM_OK) um_orbit_finals_destroy(&finals);
  *out = finals;
  return status;
}

void um_orbit_finals_destroy(struct um_orbit_finals **finals)
{
  if (!finals || !*finals) return;
  struct um_context *context = (*finals)->context;
  UM_FREE(context, (*finals)->t, (*finals)->ut1_tai, (*finals)->xp, (*finals)->yp, *finals);
  *finals = NULL;
}

enum um_status um_orbit_earth_orientation_at(struct um_context *context,
                                             const struct um_orbit_earth_orientation *orientation,
                                             double t_tai, double *ut1_utc, double *xp, double *yp)
{
  const struct um_orbit_finals *f = orientation->finals;
  *ut1_utc = orientation->ut1_utc;
  *xp = orientation->xp;
  *yp = orientation->yp;
  if (!f) return UM_OK;

  if (!(t_tai >= f->t[0] && t_tai <= f->t[f->n - 1])) {
    char at[32], first[32], last[32];
    um_orbit_time_format(t_tai, at);
    um_orbit_time_format(f->t[0], first);
    um_orbit_time_format(f->t[f->n - 1], last);
    return um_core_fail(context, UM_ERR_INPUT,
                        "Earth orientation is wanted at %s; the finals table covers %s to %s", at,
                        first, last);
  }
  double utc[2];
  um_orbit_time_utc(t_tai, utc);
  /* UT1 - UTC = (UT1 - TAI) + (TAI - UTC) at this instant */
  double tai_utc; /* [s] */
  int year, month, day;
  double fraction;
  eraJd2cal(utc[0], utc[1], &year, &month, &day, &fraction);
  eraDat(year, month, day, fraction, &tai_utc);
  *ut1_utc = um_core_interpolate(f->t, f->ut1_tai, f->n, t_tai) + tai_utc;
  *xp = um_core_interpolate(f->t, f->xp, f->n, t_tai);
  *yp = um_core_interpolate(f->t, f->yp, f->n, t_tai);
  return UM_OK;
}
