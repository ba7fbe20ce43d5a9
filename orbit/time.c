/* Time scales: UTC text to and from TAI seconds, and the two-part Julian dates that ERFA takes.
 *
 *   t_tai = 86400 (JD_TAI - 2451545.0)                       [s]
 *   TT    = TAI + 32.184 s,  UTC = TAI - leap seconds,  UT1 = UTC + (UT1 - UTC)
 *
 * UTC Julian dates are ERFA's quasi-JD: a day with a leap second is 86401 s long.
 * Reference: IERS Conventions 2010 (TN36), chapter 10; leap seconds as compiled into ERFA. */
#include "orbit/time.h"

#include <erfa.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double J2000 = 2451545.0;     /* [d] */
static const double MJD_ZERO = 2400000.5;  /* [d] */
static const double DAY = 86400.0;         /* [s] */
static const double TT_MINUS_TAI = 32.184; /* [s] */

/* Fields of an ISO 8601 date and time. */
struct calendar {
  int year, month, day, hour, minute;
  double second; /* [s] */
};

/* Exactly `digits` decimal digits at *text, which moves behind them. */
static bool digits_read(const char **text, int digits, int *value)
{
  *value = 0;
  for (int i = 0; i < digits; i++) {
    char c = **text;
    if (c < '0' || c > '9') return false;
    *value = 10 * *value + (c - '0');
    (*text)++;
  }
  return true;
}

static bool letter_read(const char **text, char letter)
{
  if (**text != letter) return false;
  (*text)++;
  return true;
}

/* ss[.f...]: at most 9 decimals, taken as one integer so that the rounding is that of a division.
 */
static bool second_read(const char **text, double *second)
{
  int whole;
  if (!digits_read(text, 2, &whole)) return false;
  *second = whole;
  if (**text != '.') return true;
  (*text)++;
  double numerator = 0.0, denominator = 1.0;
  int count = 0;
  for (; **text >= '0' && **text <= '9'; (*text)++, count++) {
    if (count >= 9) continue;
    numerator = 10.0 * numerator + (**text - '0');
    denominator *= 10.0;
  }
  *second += numerator / denominator;
  return count > 0;
}

static bool calendar_read(const char *text, struct calendar *c)
{
  const char *p = text;
  bool good = digits_read(&p, 4, &c->year) && letter_read(&p, '-') &&
              digits_read(&p, 2, &c->month) && letter_read(&p, '-') &&
              digits_read(&p, 2, &c->day) && (letter_read(&p, 'T') || letter_read(&p, ' ')) &&
              digits_read(&p, 2, &c->hour) && letter_read(&p, ':') &&
              digits_read(&p, 2, &c->minute) && letter_read(&p, ':') && second_read(&p, &c->second);
  if (!good) return false;
  if (*p == 'Z') p++;
  return *p == '\0';
}

/* The fault that eraDtf2d reports, in words; NULL when the date is good. +1 (a year for which
 * leap seconds are not yet announced) is accepted. */
static const char *calendar_fault(int code)
{
  switch (code) {
  case 0:
  case 1:
    return NULL;
  case 2:
  case 3:
    return "that minute has no leap second (seconds are below 60)";
  case -2:
    return "the month is 01 to 12";
  case -3:
    return "that month does not have this day";
  case -4:
    return "the hour is 00 to 23";
  case -5:
    return "the minute is 00 to 59";
  case -6:
    return "the second is 00 to 59 (60 in a leap second)";
  default:
    return "not a date";
  }
}

bool um_orbit_time_parse_field(const char *text, void *target, char *why, size_t why_size)
{
  struct calendar c;
  if (!calendar_read(text, &c)) {
    snprintf(why, why_size, "'%.40s' is not a UTC time like 2016-09-21T20:33:00.000Z", text);
    return false;
  }
  if (c.year < 1960 || c.year > 2100) {
    snprintf(why, why_size, "'%.40s': the year %d is outside 1960 to 2100", text, c.year);
    return false;
  }
  double d1, d2;
  int code = eraDtf2d("UTC", c.year, c.month, c.day, c.hour, c.minute, c.second, &d1, &d2);
  const char *fault = calendar_fault(code);
  if (!fault && c.second >= 61.0) fault = calendar_fault(2);
  if (fault) {
    snprintf(why, why_size, "'%.40s': %s", text, fault);
    return false;
  }
  *(double *)target = um_orbit_time_from_utc_jd(d1, d2);
  return true;
}

bool um_orbit_time_parse_hook(const char *text, void *target, char *accepted, size_t size)
{
  char why[160];
  struct calendar c;
  if (um_orbit_time_parse_field(text, target, why, sizeof why)) return true;
  /* behind the text that it quotes stands what was broken of a time that could be read */
  const char *fault = calendar_read(text, &c) ? strstr(why, "': ") : NULL;
  snprintf(accepted, size, "a UTC time like 2016-09-21T20:33:00Z%s%s%s", fault != NULL ? " (" : "",
           fault != NULL ? fault + 3 : "", fault != NULL ? ")" : "");
  return false;
}

/* TAI less the clock of a scale that has no leap seconds [s]. */
static const struct {
  const char *name;
  double behind;
} scales[] = {{"TAI", 0.0}, {"TT", -32.184}, {"TDT", -32.184}, {"GPS", 19.0}};
#define SCALES (sizeof scales / sizeof *scales)

/* Its place in these, or SCALES. */
static size_t scale_find(const char *scale)
{
  size_t k = 0;
  while (k < SCALES && strcmp(scale, scales[k].name) != 0) k++;
  return k;
}

bool um_orbit_time_scale_is_known(const char *scale)
{
  return strcmp(scale, "UTC") == 0 || scale_find(scale) < SCALES;
}

/* Year and day of the year as year, month and day; other texts as they are. */
static void date_by_month(const char *text, char out[64])
{
  const char *p = text;
  int year, day, y, m, d;
  double jd, mjd, part;
  if (digits_read(&p, 4, &year) && letter_read(&p, '-') && digits_read(&p, 3, &day) && *p == 'T' &&
      day > 0 && eraCal2jd(year, 1, 1, &jd, &mjd) == 0 &&
      eraJd2cal(jd, mjd + day - 1, &y, &m, &d, &part) == 0 && y == year)
    snprintf(out, 64, "%04d-%02d-%02d%s", y, m, d, p);
  else
    snprintf(out, 64, "%s", text);
}

bool um_orbit_time_parse_message(const char *text, const char *scale, double *t_tai, char *accepted,
                                 size_t size)
{
  char date[64];
  struct calendar c;
  double d1, d2;
  date_by_month(text, date);
  size_t k = scale_find(scale);
  if (k == SCALES) return um_orbit_time_parse_hook(date, t_tai, accepted, size);
  if (!calendar_read(date, &c) || c.year < 1960 || c.year > 2100 || c.second >= 60.0 ||
      eraDtf2d("TAI", c.year, c.month, c.day, c.hour, c.minute, c.second, &d1, &d2) < 0) {
    snprintf(accepted, size, "a time of %s like 2016-09-21T20:33:00 from 1960 to 2100", scale);
    return false;
  }
  *t_tai = (d1 - J2000) * DAY + d2 * DAY + scales[k].behind;
  return true;
}

bool um_orbit_time_from_mjd(double day, double seconds, const char *scale, double *t_tai)
{
  size_t k = scale_find(scale);
  if (!(day == floor(day) && day >= 36934.0 && day < 88434.0 && seconds >= 0.0 &&
        seconds < 86401.0))
    return false; /* 1960 to 2100 */
  double begin = k == SCALES ? um_orbit_time_from_utc_jd(MJD_ZERO, day)
                             : (MJD_ZERO - J2000 + day) * DAY + scales[k].behind;
  *t_tai = begin + seconds;
  return true;
}

enum um_status um_orbit_time_parse(struct um_context *context, const char *utc, double *t_tai)
{
  char why[160];
  if (um_orbit_time_parse_field(utc, t_tai, why, sizeof why)) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s", why);
}

double um_orbit_time_from_utc_jd(double jd1, double jd2)
{
  double a1, a2;
  eraUtctai(jd1, jd2, &a1, &a2); /* +1: a year without announced leap seconds; the last holds */
  return (a1 - J2000) * DAY + a2 * DAY;
}

/* TAI as J2000 + whole days, and the fraction: no digit of t_tai is lost. */
static void tai_split(double t_tai, double jd_tai[2])
{
  double whole = floor(t_tai / DAY);
  jd_tai[0] = J2000 + whole;
  jd_tai[1] = (t_tai - whole * DAY) / DAY;
}

void um_orbit_time_tt(double t_tai, double jd_tt[2])
{
  tai_split(t_tai, jd_tt);
  jd_tt[1] += TT_MINUS_TAI / DAY;
}

void um_orbit_time_utc(double t_tai, double jd_utc[2])
{
  double jd_tai[2];
  tai_split(t_tai, jd_tai);
  eraTaiutc(jd_tai[0], jd_tai[1], &jd_utc[0], &jd_utc[1]);
}

void um_orbit_time_utc_clock(double t_tai, double *mjd, double *seconds)
{
  double jd_utc[2], zero;
  int year, month, day, hmsf[4];
  *mjd = *seconds = NAN;
  if (!isfinite(t_tai)) return;
  um_orbit_time_utc(t_tai, jd_utc);
  if (eraD2dtf("UTC", 9, jd_utc[0], jd_utc[1], &year, &month, &day, hmsf) < 0) return;
  eraCal2jd(year, month, day, &zero, mjd);
  *seconds = 3600.0 * hmsf[0] + 60.0 * hmsf[1] + hmsf[2] + 1e-9 * hmsf[3];
}

double um_orbit_time_unix(double t_tai)
{
  double mjd, seconds;
  um_orbit_time_utc_clock(t_tai, &mjd, &seconds);
  return DAY * (mjd - 40587.0) + seconds;
}

int um_orbit_time_leap_seconds(double from, double to)
{
  double mjd[2], seconds[2];
  um_orbit_time_utc_clock(from, &mjd[0], &seconds[0]);
  um_orbit_time_utc_clock(to, &mjd[1], &seconds[1]);
  double clock = (mjd[1] - mjd[0]) * DAY + seconds[1] - seconds[0];
  return (int)lround(to - from - clock);
}

void um_orbit_time_ut1(double t_tai, double ut1_utc, double jd_ut1[2])
{
  double jd_utc[2];
  um_orbit_time_utc(t_tai, jd_utc);
  eraUtcut1(jd_utc[0], jd_utc[1], ut1_utc, &jd_ut1[0], &jd_ut1[1]);
}

void um_orbit_time_format(double t_tai, char out[32])
{
  double jd_utc[2];
  int year, month, day, hmsf[4];
  if (!isfinite(t_tai)) {
    snprintf(out, 32, "not-a-time");
    return;
  }
  um_orbit_time_utc(t_tai, jd_utc);
  if (eraD2dtf("UTC", 3, jd_utc[0], jd_utc[1], &year, &month, &day, hmsf) < 0) {
    snprintf(out, 32, "not-a-time");
    return;
  }
  snprintf(out, 32, "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", year % 10000, month, day, hmsf[0],
           hmsf[1], hmsf[2], hmsf[3]);
}
