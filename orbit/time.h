/* Time scales. Inside, time is one double: TAI seconds since 2000-01-01T12:00:00 TAI (t_tai),
 * which resolves 0.1 us in this century. */
#ifndef UMBRA_ORBIT_TIME_H
#define UMBRA_ORBIT_TIME_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/context.h"

/* ISO 8601 UTC "2016-09-21T20:33:00[.fff][Z]", or with a blank for the T -> t_tai, leap seconds by
 * ERFA (second 60 allowed only where one was). UM_ERR_INPUT. Years 1960-2100. */
enum um_status um_orbit_time_parse(struct um_context *context, const char *utc, double *t_tai);
/* The same without a context; target is a double, `why` takes the problem, with the text. */
bool um_orbit_time_parse_field(const char *text, void *target, char *why, size_t why_size);
/* The same as the parse hook of a schema: `accepted` takes what is accepted instead. */
bool um_orbit_time_parse_hook(const char *text, void *target, char *accepted, size_t size);
/* Times of messages: one of UTC, TAI, TT (or TDT), GPS; the date by month and day, or by the day of
 * the year, "2016-265T20:33:00". accepted: as above. */
bool um_orbit_time_scale_is_known(const char *scale);
bool um_orbit_time_parse_message(const char *text, const char *scale, double *t_tai, char *accepted,
                                 size_t size);
/* Modified Julian day (whole) and seconds of it, by the clock of a scale; false: out of range. */
bool um_orbit_time_from_mjd(double day, double seconds, const char *scale, double *t_tai);
/* t_tai -> "2016-09-21T20:33:00.000Z", rounded to 1 ms; out holds 25 bytes. */
void um_orbit_time_format(double t_tai, char out[32]);
/* Two-part Julian dates of other scales. ut1_utc [s]. */
void um_orbit_time_tt(double t_tai, double jd_tt[2]);
void um_orbit_time_utc(double t_tai, double jd_utc[2]);
void um_orbit_time_ut1(double t_tai, double ut1_utc, double jd_ut1[2]);
/* What a UTC clock shows: modified Julian day, and seconds of that day to 1 ns, from 0 up to 86400,
 * or 86401 on a day that ends in a leap second. */
void um_orbit_time_utc_clock(double t_tai, double *mjd, double *seconds);
/* The same as seconds since 1970-01-01, days of 86400 s, as POSIX counts. */
double um_orbit_time_unix(double t_tai);
/* Leap seconds put in between two times, from < to: to - from less what the clock moved on, its
 * days being taken as 86400 s. */
int um_orbit_time_leap_seconds(double from, double to);
/* From a UTC Julian date (two parts, ERFA's quasi-JD) to t_tai. */
double um_orbit_time_from_utc_jd(double jd1, double jd2);

#endif
