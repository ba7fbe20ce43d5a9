/* Two-line element sets: fixed columns, every field checked, one-line messages.
 *
 * Columns and checksum (sum of digits, a minus counts 1, modulo 10) as in Hoots & Roehrich 1980,
 * Spacetrack Report 3, and Vallado et al. 2006, AIAA 2006-6753, appendix B. Alpha-5 catalogue
 * numbers: a letter A-Z without I and O stands for 10-33 in front of four digits. */
#include "orbit/tle.h"

#include <erfa.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "orbit/time.h"

enum { LINE_LENGTH = 69, LINES_MAX = 3 };

/* One line of the set: its text without trailing blanks. */
struct tle_line {
  const char *text;
  size_t length;
};

/* A field of a line: 1-based columns, what the messages call it, and what is accepted. */
struct tle_field {
  int line;
  size_t first, last;
  const char *name;
  double minimum, maximum; /* accepted range, both ends included, in the field's own unit */
  const char *unit;
};

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

/* Split into lines that are not empty; a byte-order mark is skipped. */
static enum um_status lines_split(struct um_context *context, const char *text,
                                  struct tle_line line[LINES_MAX], size_t *count)
{
  if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) text += 3;
  *count = 0;
  while (*text) {
    size_t length = strcspn(text, "\n"), trimmed = length;
    while (trimmed > 0 && strchr(" \t\r", text[trimmed - 1])) trimmed--;
    if (trimmed > 0) {
      if (*count == LINES_MAX)
        return um_core_fail(context, UM_ERR_INPUT,
                            "TLE: more than three lines; two lines, with or without a name line "
                            "before them, are accepted");
      line[(*count)++] = (struct tle_line){text, trimmed};
    }
    text += length + (text[length] == '\n');
  }
  return UM_OK;
}

static int checksum_of(const char *line)
{
  int sum = 0;
  for (size_t i = 0; i < LINE_LENGTH - 1; i++) {
    if (is_digit(line[i])) sum += line[i] - '0';
    if (line[i] == '-') sum += 1;
  }
  return sum % 10;
}

static enum um_status line_check(struct um_context *context, const struct tle_line *line,
                                 int number, int checksum)
{
  if (line->text[0] != '0' + number || (line->length > 1 && line->text[1] != ' '))
    return um_core_fail(context, UM_ERR_INPUT, "TLE line %d: begins with '%.2s', '%d ' is accepted",
                        number, line->text, number);
  if (line->length != LINE_LENGTH)
    return um_core_fail(context, UM_ERR_INPUT, "TLE line %d: %zu characters, %d are accepted",
                        number, line->length, LINE_LENGTH);
  for (size_t i = 0; i < LINE_LENGTH; i++)
    if (line->text[i] < ' ' || line->text[i] > '~')
      return um_core_fail(context, UM_ERR_INPUT,
                          "TLE line %d, column %zu: character code %d, printable ASCII is accepted",
                          number, i + 1, (int)(unsigned char)line->text[i]);
  char says = line->text[LINE_LENGTH - 1];
  if (!checksum) return UM_OK;
  if (!is_digit(says))
    return um_core_fail(context, UM_ERR_INPUT,
                        "TLE line %d, column 69 (checksum): '%c', a digit is accepted", number,
                        says);
  int sum = checksum_of(line->text);
  if (says != '0' + sum)
    return um_core_fail(context, UM_ERR_INPUT, "TLE line %d: checksum is %d, the line says %c",
                        number, sum, says);
  return UM_OK;
}

static enum um_status field_fail(struct um_context *context, const struct tle_field *f,
                                 const char *line, const char *accepted)
{
  return um_core_fail(context, UM_ERR_INPUT, "TLE line %d, columns %zu-%zu (%s): '%.*s', %s",
                      f->line, f->first, f->last, f->name, (int)(f->last - f->first + 1),
                      line + f->first - 1, accepted);
}

/* Cut the blanks off both ends of a field; an empty field leaves *length 0. */
static const char *field_trim(const struct tle_field *f, const char *line, size_t *length)
{
  const char *p = line + f->first - 1, *end = line + f->last;
  while (p < end && *p == ' ') p++;
  while (end > p && end[-1] == ' ') end--;
  *length = (size_t)(end - p);
  return p;
}

static enum um_status range_check(struct um_context *context, const struct tle_field *f,
                                  const char *line, double value)
{
  char accepted[96];
  if (value >= f->minimum && value <= f->maximum) return UM_OK;
  snprintf(accepted, sizeof accepted, "%g to %g%s%s is accepted", f->minimum, f->maximum,
           f->unit[0] ? " " : "", f->unit);
  return field_fail(context, f, line, accepted);
}

/* [sign] digits [. digits]; the mantissa stays below 2^53, so the one division rounds correctly. */
static enum um_status decimal_read(struct um_context *context, const struct tle_field *f,
                                   const char *line, double *value)
{
  size_t n, i = 0, digits = 0;
  const char *p = field_trim(f, line, &n);
  double sign = 1.0, mantissa = 0.0, scale = 1.0;
  bool point = false;
  if (i < n && (p[i] == '-' || p[i] == '+')) sign = p[i++] == '-' ? -1.0 : 1.0;
  for (; i < n; i++) {
    if (p[i] == '.' && !point) {
      point = true;
    } else if (is_digit(p[i])) {
      mantissa = 10.0 * mantissa + (p[i] - '0');
      if (point) scale *= 10.0;
      digits++;
    } else {
      break;
    }
  }
  if (i < n || digits == 0)
    return field_fail(context, f, line, "a number with digits and one decimal point is accepted");
  *value = sign * mantissa / scale;
  return range_check(context, f, line, *value);
}

/* "-12345-6" = -0.12345e-6: sign, five digits after an implied point, signed power of ten. */
static enum um_status exponent_read(struct um_context *context, const struct tle_field *f,
                                    const char *line, double *value)
{
  const char *p = line + f->first - 1;
  double mantissa = 0.0;
  bool good = strchr(" +-", p[0]) != NULL && strchr("+- ", p[6]) != NULL && is_digit(p[7]);
  for (int i = 1; i <= 5 && good; i++) {
    good = is_digit(p[i]);
    mantissa = 10.0 * mantissa + (p[i] - '0');
  }
  if (!good)
    return field_fail(context, f, line, "a number like ' 12345-3' for 0.12345e-3 is accepted");
  double power = p[7] - '0';
  *value = (p[0] == '-' ? -1.0 : 1.0) * (mantissa / 1e5) * pow(10.0, p[6] == '-' ? -power : power);
  return UM_OK;
}

/* Digits only, with blanks allowed in front: eccentricity without its point, counters. */
static enum um_status digits_read(struct um_context *context, const struct tle_field *f,
                                  const char *line, double *value)
{
  size_t n;
  const char *p = field_trim(f, line, &n);
  *value = 0.0;
  for (size_t i = 0; i < n; i++) {
    if (!is_digit(p[i])) return field_fail(context, f, line, "digits are accepted");
    *value = 10.0 * *value + (p[i] - '0');
  }
  if (n == 0) return field_fail(context, f, line, "digits are accepted");
  return range_check(context, f, line, *value);
}

static enum um_status catalogue_read(struct um_context *context, const char *line, int number,
                                     int *value)
{
  static const char letters[] = "ABCDEFGHJKLMNPQRSTUVWXYZ"; /* Alpha-5: no I, no O */
  const struct tle_field f = {number, 3, 7, "catalogue number", 0, 0, ""};
  size_t n;
  const char *p = field_trim(&f, line, &n);
  int first = 0;
  size_t i = 0;
  const char *letter = n == 5 ? strchr(letters, p[0]) : NULL;
  if (letter) {
    first = 10 + (int)(letter - letters);
    i = 1;
  }
  *value = first;
  for (; i < n && is_digit(p[i]); i++) *value = 10 * *value + (p[i] - '0');
  if (n == 0 || i < n)
    return field_fail(
        context, &f, line,
        "five digits, or a letter (not I, O) and four digits (Alpha-5), are accepted");
  return UM_OK;
}

/* Columns 19-32: two-digit year (57-99: 1957-1999, 00-56: 2000-2056), day of year from 1.0. */
static enum um_status epoch_read(struct um_context *context, const char *line,
                                 struct um_orbit_tle *out)
{
  const struct tle_field year_field = {1, 19, 20, "epoch year", 0, 99, ""};
  struct tle_field day_field = {1, 21, 32, "epoch day of year", 1, 0, ""};
  double two_digits, day, djm0, mjd;
  UM_TRY(digits_read(context, &year_field, line, &two_digits));
  int year = (int)two_digits + (two_digits < 57 ? 2000 : 1900);
  bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  day_field.maximum = leap ? 366.99999999 : 365.99999999;
  UM_TRY(decimal_read(context, &day_field, line, &day));

  eraCal2jd(year, 1, 1, &djm0, &mjd);
  out->epoch_jd[0] = djm0 + mjd + floor(day) - 1.0;
  out->epoch_jd[1] = day - floor(day);
  out->epoch_tai = um_orbit_time_from_utc_jd(out->epoch_jd[0], out->epoch_jd[1]);
  return UM_OK;
}

static enum um_status line_1_read(struct um_context *context, const char *line,
                                  struct um_orbit_tle *out)
{
  const struct tle_field dot = {1, 34, 43, "half mean motion rate", -1, 1, "rev/day^2"};
  const struct tle_field ddot = {1, 45, 52, "sixth of mean motion acceleration", 0, 0, ""};
  const struct tle_field bstar = {1, 54, 61, "B*", 0, 0, ""};
  const struct tle_field designator = {1, 10, 17, "international designator", 0, 0, ""};
  size_t n;
  const char *p = field_trim(&designator, line, &n);
  memcpy(out->designator, p, n);
  out->designator[n] = '\0';
  UM_TRY(epoch_read(context, line, out));
  UM_TRY(decimal_read(context, &dot, line, &out->mean_motion_dot));
  UM_TRY(exponent_read(context, &ddot, line, &out->mean_motion_ddot));
  return exponent_read(context, &bstar, line, &out->bstar);
}

static enum um_status line_2_read(struct um_context *context, const char *line,
                                  struct um_orbit_tle *out)
{
  static const struct tle_field angle[4] = {{2, 9, 16, "inclination", 0, 180, "deg"},
                                            {2, 18, 25, "right ascension", 0, 360, "deg"},
                                            {2, 35, 42, "argument of perigee", 0, 360, "deg"},
                                            {2, 44, 51, "mean anomaly", 0, 360, "deg"}};
  static const struct tle_field eccentricity = {2, 27, 33, "eccentricity", 0, 9999999, ""};
  static const struct tle_field motion = {2, 53, 63, "mean motion", 1e-8, 20, "rev/day"};
  double *target[4] = {&out->inclination, &out->raan, &out->argument_of_perigee,
                       &out->mean_anomaly};
  for (int k = 0; k < 4; k++) {
    UM_TRY(decimal_read(context, &angle[k], line, target[k]));
    *target[k] *= UM_DEG;
  }
  double value;
  UM_TRY(digits_read(context, &eccentricity, line, &value));
  out->eccentricity = value / 1e7;
  UM_TRY(decimal_read(context, &motion, line, &value));
  out->mean_motion = value / (1440.0 / (2.0 * UM_PI)); /* rev/day -> rad/min */
  return UM_OK;
}

enum um_status um_orbit_tle_parse(struct um_context *context, const char *text, int checksum,
                                  struct um_orbit_tle *out)
{
  struct tle_line line[LINES_MAX];
  size_t count;
  int second_number;
  UM_TRY(lines_split(context, text, line, &count));
  /* a first line of another length that does not begin with a line number is the name */
  bool named = count > 0 && line[0].length != LINE_LENGTH && strncmp(line[0].text, "1 ", 2) != 0 &&
               strncmp(line[0].text, "2 ", 2) != 0;
  size_t first = count == 3 || named ? 1 : 0;
  if (count < first + 2)
    return um_core_fail(context, UM_ERR_INPUT,
                        "TLE: line %d is missing; two lines that begin with '1 ' and '2 ', with or "
                        "without a name line before them, are accepted",
                        count > first && strncmp(line[first].text, "2 ", 2) != 0 ? 2 : 1);
  const char *one = line[first].text, *two = line[first + 1].text;
  *out = (struct um_orbit_tle){0};
  UM_TRY(line_check(context, &line[first], 1, checksum));
  UM_TRY(line_check(context, &line[first + 1], 2, checksum));
  UM_TRY(catalogue_read(context, one, 1, &out->catalogue_number));
  UM_TRY(catalogue_read(context, two, 2, &second_number));
  if (second_number != out->catalogue_number)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "TLE: line 1 is of catalogue number %.5s, line 2 of %.5s; equal numbers are "
        "accepted",
        one + 2, two + 2);
  UM_TRY(line_1_read(context, one, out));
  return line_2_read(context, two, out);
}
