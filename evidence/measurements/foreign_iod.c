/* Observations of visual observers in the IOD format (G. D. Lewis 1998, clarified 2002), a line of
 * fixed columns each: those with a magnitude as `time_utc,MAG,MAG_sigma,flash_period_s,station`.
 * Columns, from 1: 1-5 object, 17-20 station, 22 sky, 24-40 YYYYMMDDHHMMSSsss of UTC, 67 sign and
 * 68-70 MMm of the magnitude, 72-73 Mm of its uncertainty, 75-80 SSSsss of the flash period. Other
 * lines, and angles, are passed over. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/number.h"
#include "evidence/measurements/foreign_kind.h"
#include "evidence/measurements/foreign_line.h"
#include "orbit/time.h"

#define COLUMNS 80

struct line {
  char text[COLUMNS + 1]; /* blanks behind its end */
};

/* The columns `first` to `last`, blanks off their end. */
static const char *field(const struct line *line, int first, int last, char out[COLUMNS + 1])
{
  int n = last - first + 1;
  memcpy(out, line->text + first - 1, (size_t)n);
  while (n > 0 && out[n - 1] == ' ') n--;
  out[n] = '\0';
  return out;
}

static void take_line(const char *from, size_t length, struct line *line)
{
  while (length > 0 && isspace((unsigned char)from[length - 1]) != 0) length--;
  if (length > COLUMNS) length = COLUMNS;
  memset(line->text, ' ', COLUMNS);
  line->text[COLUMNS] = '\0';
  memcpy(line->text, from, length);
}

/* Whole digits before blanks: 0 is none. */
static bool is_digits(const char *text, int least)
{
  int n = (int)strspn(text, "0123456789");
  return n >= least && text[n] == '\0';
}

/* A line of the format, by the places of its blanks, its sky and its date. */
static bool is_observation(const struct line *line)
{
  char date[COLUMNS + 1], station[COLUMNS + 1];
  const char *t = line->text;
  return is_digits(field(line, 24, 31, date), 8) && (t[23] == '1' || t[23] == '2') &&
         strchr("EGFPBTCO", t[21]) != NULL && t[15] == ' ' && t[20] == ' ' && t[22] == ' ' &&
         is_digits(field(line, 17, 20, station), 4);
}

/* "05" with a point before its last digit; what is left out at the end is 0. */
static double with_point(const char *digits, int before)
{
  char text[COLUMNS + 2];
  double value = 0.0;
  int n = (int)strlen(digits), whole = n < before ? n : before;
  snprintf(text, sizeof text, "%.*s.%s0", whole, digits, digits + whole);
  (void)um_core_number_parse(text, &value);
  return value;
}

struct reader {
  struct um_compare_foreign_at at;
  char object[6];
  size_t magnitudes;
};

static enum um_status put_time(const struct reader *r, const struct line *line, FILE *csv)
{
  char clock[COLUMNS + 1], text[40], utc[32], why[200];
  double t;
  const char *d = line->text + 23;
  field(line, 32, 40, clock);
  if (!is_digits(clock, 4))
    return um_compare_foreign_refuse(&r->at, clock, "HHMMSSsss in columns 32 to 40, HHMM at least");
  memset(clock + strlen(clock), '0', COLUMNS - strlen(clock));
  snprintf(text, sizeof text, "%.4s-%.2s-%.2sT%.2s:%.2s:%.2s.%.3s", d, d + 4, d + 6, clock,
           clock + 2, clock + 4, clock + 6);
  if (!um_orbit_time_parse_hook(text, &t, why, sizeof why))
    return um_compare_foreign_refuse(&r->at, text, why);
  um_orbit_time_format(t, utc);
  fputs(utc, csv);
  return UM_OK;
}

static enum um_status take_object(struct reader *r, const struct line *line)
{
  char object[COLUMNS + 1];
  field(line, 1, 5, object);
  if (r->object[0] == '\0') memcpy(r->object, object, 6);
  if (strcmp(r->object, object) == 0) return UM_OK;
  return um_core_fail(r->at.context, UM_ERR_INPUT,
                      "%s:%d: object '%s' after '%s'; accepted: observations of one object",
                      r->at.path, r->at.line, object, r->object);
}

static enum um_status take_observation(struct reader *r, const struct line *line, FILE *csv)
{
  char magnitude[COLUMNS + 1], sigma[COLUMNS + 1], period[COLUMNS + 1], station[COLUMNS + 1];
  char sign = line->text[66];
  if (sign != '+' && sign != '-') return UM_OK;
  field(line, 68, 70, magnitude);
  field(line, 72, 73, sigma);
  memcpy(period, line->text + 74, 6);
  period[6] = '\0';
  if (!is_digits(magnitude, 2))
    return um_compare_foreign_refuse(&r->at, magnitude,
                                     "a magnitude MMm in columns 68 to 70, '070' for 7.0");
  if (!is_digits(sigma, 0))
    return um_compare_foreign_refuse(&r->at, sigma, "an uncertainty Mm in columns 72 and 73");
  UM_TRY(take_object(r, line));
  UM_TRY(put_time(r, line, csv));
  um_core_csv_put_number(csv, (sign == '-' ? -1.0 : 1.0) * with_point(magnitude, 2));
  fputc(',', csv);
  if (sigma[0] != '\0') fprintf(csv, "%g", with_point(sigma, 1));
  fputc(',', csv);
  /* SSSsss; blanks before or behind are digits that are not known */
  for (int i = 0; i < 6; i++)
    if (period[i] == ' ') period[i] = '0';
  if (is_digits(period, 6) && strcmp(period, "000000") != 0)
    fprintf(csv, "%g", with_point(period, 3));
  um_core_csv_put_text(csv, field(line, 17, 20, station), "");
  r->magnitudes++;
  return UM_OK;
}

/* The next line of the file; false behind the last. */
static bool line_next(const char *bytes, size_t length, size_t *at, struct line *line)
{
  if (*at >= length) return false;
  const char *end = memchr(bytes + *at, '\n', length - *at);
  size_t n = end == NULL ? length - *at : (size_t)(end - (bytes + *at));
  take_line(bytes + *at, n, line);
  *at += n + 1;
  return true;
}

/* The header stands before the first line: a line of the table is that of the file and one. What
 * can be wrong in a row is said here. */
static enum um_status convert(struct um_context *context, const char *path, const char *bytes,
                              size_t length, FILE *csv)
{
  struct reader r = {.at = {context, path, 0}};
  struct line line;
  fputs("time_utc,MAG,MAG_sigma,flash_period_s,station\n", csv);
  for (size_t at = 0; line_next(bytes, length, &at, &line);) {
    if (++r.at.line % 4096 == 0) UM_TRY(um_core_stop_check(context, "observations were read"));
    if (is_observation(&line)) UM_TRY(take_observation(&r, &line, csv));
    fputc('\n', csv);
  }
  if (r.magnitudes > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: no line has a magnitude; accepted: lines of the IOD format with a sign "
                      "in column 67 and MMm behind it",
                      path);
}

/* One of the first lines is of the format: such logs come in letters. */
static bool is(const char *bytes, size_t length)
{
  struct line line;
  size_t at = 0;
  for (int i = 0; i < 100 && line_next(bytes, length, &at, &line); i++)
    if (is_observation(&line)) return true;
  return false;
}

const struct um_compare_foreign_kind um_compare_foreign_iod = {is, convert};
