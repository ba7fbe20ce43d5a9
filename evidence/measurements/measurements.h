/* Measurements as the user has them: a tidy CSV of any mix of quantities. */
#ifndef UMBRA_COMPARE_MEASUREMENTS_H
#define UMBRA_COMPARE_MEASUREMENTS_H

#include "evidence/measurements/set.h"

/* Temperatures of a place that stay below it are Celsius or of a cooled instrument [K]. */
#define UM_COMPARE_COLD 100.0

/* Read `time_utc,quantity,of,value,sigma` (or time_unix_s, jd_utc, mjd_utc for the first:
 * orbit/time_form.h; temperature_C or temperature_K for a temperature) with optional columns
 * exposure_s, flag, track, satellite_height_km, azimuth_deg, elevation_deg, station. Refused, one
 * line naming file and line: unreadable, missing or unknown columns, no rows, unknown quantity,
 * non-finite or non-numeric value, sigma not positive (empty is allowed), times out of order within
 * a track, two rows of one channel and track at one time, a magnitude beyond +-40, a temperature <=
 * 0 K or one that names no unit and stays below UM_COMPARE_COLD in all rows of its place, a
 * negative exposure, a flag that is not a whole number, incomplete independent geometry, a height
 * <= 0, an azimuth beyond +-360 deg, an elevation beyond +-90 deg. Values may be negative.
 * UM_ERR_IO, UM_ERR_INPUT, UM_ERR_MEMORY; *out is NULL then. The caller destroys. */
enum um_status um_compare_measurements_read(struct um_context *context, const char *path,
                                            struct um_compare_measurements **out);
#endif
