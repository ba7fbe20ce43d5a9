/* Times of a table by the name of their column: UTC text, POSIX seconds, Julian dates.
 *
 *   time_unix_s = 86400 (days since 1970-01-01) + seconds of the UTC day, leap seconds not counted
 *   jd_utc = mjd_utc + 2400000.5 = days since noon of -4712-01-01; a day that ends in a leap second
 *            is 86401 s long, as SOFA, ERFA and astropy have it
 *
 * A Julian date as a double resolves 40 us: here the digits before and behind the point are read
 * apart, and the whole days never meet the fraction.
 * Reference: POSIX.1-2008, 4.16; SOFA Time Scale and Calendar Tools (2021), 3.1 and 4.5. */
#include "orbit/time_form.h"

#include <erfa.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "orbit/time.h"

static const double UNIX_EPOCH = 2440587.5; /* JD of 1970-01-01 [d] */
static const double MJD_ZERO = 2400000.5;   /* [d] */

/* A form, and its values of 1960-01-01 and 2101-01-01, between which times are taken. */
static const struct form {
  const char *column;
  double first, end;
} forms[UM_ORBIT_TIME_FORMS] = {[UM_ORBIT_TIME_ISO] = {"time_utc", 0.0, 0.0},
                                [UM_ORBIT_TIME_UNIX] = {"time_unix_s", -315619200.0, 4133980800.0},
                                [UM_ORBIT_TIME_JD] = {"jd_utc", 2436934.5, 2488434.5},
                                [UM_ORBIT_TIME_MJD] = {"mjd_utc", 36934.0, 88434.0}};

const char *um_orbit_time_form_column(enum um_orbit_time_form form) { return forms[form].column; }

/* [-]digits[.digits] as its whole part and a fraction in [0, 1) of the same sign: value = whole +
 * fraction. At most 15 digits before the point, 18 behind it count. */
static bool decimal_split(const char *text, double *whole, double *fraction)
{
  double sign = *text == '-' ? -1.0 : 1.0, numerator = 0.0, denominator = 1.0;
  int count = 0;
  *whole = 0.0;
  if (*text == '-') text++;
  for (; *text >= '0' && *text <= '9'; text++, count++) *whole = 10.0 * *whole + (*text - '0');
  if (count == 0 || count > 15) return false;
  if (*text == '.') {
    const char *digits = ++text;
    for (; *text >= '0' && *text <= '9'; text++) {
      if (text - digits >= 18) continue;
      numerator = 10.0 * numerator + (*text - '0');
      denominator *= 10.0;
    }
    if (text == digits) return false;
  }
  *whole *= sign;
  *fraction = sign * (numerator / denominator);
  return *text == '\0';
}

static double from_unix(double whole, double fraction)
{
  double days = floor(whole / 86400.0), second = whole - 86400.0 * days;
  if (fraction < 0.0) { /* before 1970: of the second before */
    second -= 1.0;
    fraction += 1.0;
  }
  if (second < 0.0) {
    second += 86400.0;
    days -= 1.0;
  }
  int year, month, day, hour = (int)(second / 3600.0), minute = (int)(second / 60.0) - 60 * hour;
  double none, d1, d2;
  eraJd2cal(UNIX_EPOCH, days, &year, &month, &day, &none);
  eraDtf2d("UTC", year, month, day, hour, minute, second - 3600.0 * hour - 60.0 * minute + fraction,
           &d1, &d2);
  return um_orbit_time_from_utc_jd(d1, d2);
}

bool um_orbit_time_from_unix(double unix_s, double *t_tai)
{
  const struct form *form = &forms[UM_ORBIT_TIME_UNIX];
  if (!(unix_s >= form->first && unix_s < form->end)) return false;
  *t_tai = from_unix(floor(unix_s), unix_s - floor(unix_s));
  return true;
}

/* What the number would be under another name; "" where it fits none. */
static const char *other_form(double value)
{
  static const char *const words[UM_ORBIT_TIME_FORMS] = {
      [UM_ORBIT_TIME_UNIX] = "; seconds since 1970 stand in a column time_unix_s",
      [UM_ORBIT_TIME_JD] = "; Julian dates stand in a column jd_utc",
      [UM_ORBIT_TIME_MJD] = "; modified Julian dates stand in a column mjd_utc"};
  for (int f = UM_ORBIT_TIME_FORMS - 1; f > UM_ORBIT_TIME_ISO; f--) /* the narrowest first */
    if (value >= forms[f].first && value < forms[f].end) return words[f];
  value *= 1e-3;
  if (value >= forms[UM_ORBIT_TIME_UNIX].first && value < forms[UM_ORBIT_TIME_UNIX].end)
    return "; milliseconds are not taken, seconds stand in a column time_unix_s";
  return "";
}

bool um_orbit_time_form_parse(enum um_orbit_time_form form, const char *text, double *t_tai,
                              char *why, size_t why_size)
{
  static const char *const like[UM_ORBIT_TIME_FORMS] = {
      [UM_ORBIT_TIME_UNIX] = "seconds since 1970-01-01T00:00:00Z like 1474489980.000",
      [UM_ORBIT_TIME_JD] = "a Julian date like 2457653.35625000",
      [UM_ORBIT_TIME_MJD] = "a modified Julian date like 57652.85625000"};
  double whole, fraction;
  bool number = decimal_split(text, &whole, &fraction);
  if (form == UM_ORBIT_TIME_ISO) {
    if (um_orbit_time_parse_field(text, t_tai, why, why_size)) return true;
    size_t used = strlen(why);
    if (number) snprintf(why + used, why_size - used, "%s", other_form(whole + fraction));
    return false;
  }
  if (!number) {
    snprintf(why, why_size, "'%.40s' is not %s, digits without exponent", text, like[form]);
    return false;
  }
  double value = whole + fraction;
  if (!(value >= forms[form].first && value < forms[form].end)) {
    snprintf(why, why_size, "'%.40s' is not %s, of 1960 to 2100%s", text, like[form],
             other_form(value));
    return false;
  }
  if (form == UM_ORBIT_TIME_UNIX)
    *t_tai = from_unix(whole, fraction);
  else
    *t_tai =
        um_orbit_time_from_utc_jd(form == UM_ORBIT_TIME_JD ? whole : MJD_ZERO + whole, fraction);
  return true;
}

#define RECOGNISED 1e8 /* POSIX seconds that are taken for a time: anything smaller is a number */

bool um_orbit_time_form_recognise(const char *text, enum um_orbit_time_form *form)
{
  char why[256];
  double t_tai, whole, fraction;
  for (int f = UM_ORBIT_TIME_FORMS - 1; f >= 0; f--) { /* the narrowest first */
    *form = (enum um_orbit_time_form)f;
    if (!um_orbit_time_form_parse(*form, text, &t_tai, why, sizeof why)) continue;
    if (*form != UM_ORBIT_TIME_UNIX) return true;
    if (decimal_split(text, &whole, &fraction) && whole >= RECOGNISED) return true;
  }
  return false;
}

enum um_status um_orbit_time_form_find(struct um_context *context, const struct um_core_csv *csv,
                                       enum um_orbit_time_form *form, size_t *column)
{
  *form = UM_ORBIT_TIME_FORMS;
  for (int f = 0; f < UM_ORBIT_TIME_FORMS; f++) {
    size_t at = um_core_csv_find(csv, forms[f].column);
    if (at == (size_t)-1) continue;
    if (*form != UM_ORBIT_TIME_FORMS)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: header: columns '%s' and '%s'; accepted: one column of times",
                          um_core_csv_name(csv), forms[*form].column, forms[f].column);
    *form = (enum um_orbit_time_form)f;
    *column = at;
  }
  if (*form != UM_ORBIT_TIME_FORMS) return UM_OK;
  *form = UM_ORBIT_TIME_ISO;
  return um_core_csv_require(context, csv, forms[UM_ORBIT_TIME_ISO].column, column);
}
