/* Times of a table: the name of the column says how they are written. */
#ifndef UMBRA_ORBIT_TIME_FORM_H
#define UMBRA_ORBIT_TIME_FORM_H

#include <stdbool.h>
#include <stddef.h>

#include "base/core/csv.h"

enum um_orbit_time_form {
  UM_ORBIT_TIME_ISO,  /* time_utc: 2016-09-21T20:33:00.000Z, or with a blank for the T */
  UM_ORBIT_TIME_UNIX, /* time_unix_s: seconds since 1970-01-01T00:00:00Z, no leap seconds counted */
  UM_ORBIT_TIME_JD,   /* jd_utc: Julian date [d] */
  UM_ORBIT_TIME_MJD,  /* mjd_utc: modified Julian date [d] */
  UM_ORBIT_TIME_FORMS
};

/* Name of the column; borrowed, does not fail. */
const char *um_orbit_time_form_column(enum um_orbit_time_form form);
/* A field of such a column -> t_tai [s]; numbers are decimal digits without exponent, of which none
 * is lost: as exact as a double of t_tai (0.1 us). Years 1960 to 2100. False: `why` takes the
 * problem, with the text. The second 60 of a leap second has no POSIX time. */
bool um_orbit_time_form_parse(enum um_orbit_time_form form, const char *text, double *t_tai,
                              char *why, size_t why_size);
/* The form of a time whose column has a name of its own: ISO 8601, a Julian date, a modified one,
 * or POSIX seconds from 1973-03 (1e8) on. False: it is none of these. Does not fail. */
bool um_orbit_time_form_recognise(const char *text, enum um_orbit_time_form *form);
/* POSIX seconds -> t_tai [s]; a double of them resolves 0.3 us. False where they lie outside of
 * 1960 to 2100, or are no number. */
bool um_orbit_time_from_unix(double unix_s, double *t_tai);
/* The column of times that a table has. UM_ERR_INPUT: none, or more than one. */
enum um_status um_orbit_time_form_find(struct um_context *context, const struct um_core_csv *csv,
                                       enum um_orbit_time_form *form, size_t *column);

#endif
