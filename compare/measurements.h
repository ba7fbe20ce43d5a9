/* Measurements as the user has them: a tidy CSV of any mix of quantities. */
#ifndef UMBRA_COMPARE_MEASUREMENTS_H
#define UMBRA_COMPARE_MEASUREMENTS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/context.h"

enum um_compare_quantity {
  UM_QUANTITY_BAND_IRRADIANCE,   /* at the aperture [W/m^2] */
  UM_QUANTITY_RADIANT_INTENSITY, /* [W/sr] */
  UM_QUANTITY_MAGNITUDE_AB,      /* exo-atmospheric, photon counting */
  UM_QUANTITY_MAGNITUDE_VEGA,
  UM_QUANTITY_COUNT_RATE,  /* [1/s] */
  UM_QUANTITY_TEMPERATURE, /* [K] */
  UM_QUANTITY_COUNT
};
/* Name as in files ("band_irradiance") and unit ("W/m^2"); borrowed; do not fail. */
const char *um_compare_quantity_name(enum um_compare_quantity quantity);
const char *um_compare_quantity_unit(enum um_compare_quantity quantity);

/* One row. */
struct um_compare_measurement {
  double t_tai;                                /* mid-exposure at the observer [s] */
  size_t channel;                              /* index into the set's channels */
  double value;                                /* in the quantity's unit */
  double sigma;                                /* > 0; NaN when the file gives none */
  double exposure;                             /* [s]; NaN when the file gives none */
  size_t track;                                /* index into the set's tracks */
  int flag;                                    /* 0: use */
  double satellite_height, azimuth, elevation; /* independent observation [m], [rad], [rad]; NaN */
  int line;                                    /* in the file */
  size_t station;                              /* index into the set's stations; SIZE_MAX: none */
};

/* Rows of one quantity of one thing. */
struct um_compare_channel {
  enum um_compare_quantity quantity;
  char *of; /* band, part, side, node, filter or sensor, as in the file */
  size_t count;
};

struct um_compare_measurements {
  char *path;
  const char *time_column;            /* what the file calls its times; static */
  struct um_compare_measurement *row; /* [count], in file order */
  size_t count;
  struct um_compare_channel *channel; /* [nchannel], in order of first appearance */
  size_t nchannel;
  char **track; /* [ntrack] names; one track "" when the file has no column */
  size_t ntrack;
  bool independent; /* rows carry satellite height, azimuth and elevation */
  char **station;   /* [nstation] names */
  size_t nstation;
};

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
void um_compare_measurements_destroy(struct um_context *context,
                                     struct um_compare_measurements **measurements);
/* Write the same format (used by synthetic measurements): whole or not at all, beside `path` under
 * a temporary name and then renamed. Optional columns appear where a row has something to say.
 * Times to the millisecond, or the microsecond where a time is not a whole millisecond; numbers
 * with the fewest digits that read back as the same double; temperatures in K, those below
 * UM_COMPARE_COLD as temperature_K. UM_ERR_IO; UM_ERR_NUMERIC for a value
 * that the reader would refuse as not finite. */
enum um_status um_compare_measurements_write(struct um_context *context,
                                             const struct um_compare_measurements *measurements,
                                             const char *path);

#endif
