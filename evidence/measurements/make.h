/* Measurements from a caller's numbers, in place of a file. */
#ifndef UMBRA_COMPARE_MAKE_H
#define UMBRA_COMPARE_MAKE_H

#include "evidence/measurements/set.h"

/* One row as a caller has it; texts borrowed, NULL: none. */
struct um_compare_row {
  double t_tai;              /* mid-exposure at the observer [s] */
  const char *quantity, *of; /* "magnitude_ab", "vis" */
  double value, sigma;       /* in the quantity's unit; sigma NaN: none */
  double exposure;           /* [s]; NaN: not said */
  int flag;                  /* 0: use */
  const char *track, *station;
  double satellite_height, azimuth, elevation; /* [m], [rad], [rad]; NaN: an orbit says */
};

/* Rows [count] in any mix of quantities; the same rules as those of a file
 * (um_compare_measurements_read), but that temperatures are kelvin. name: what messages call the
 * set, "measurements:3" of its third row. UM_ERR_INPUT, UM_ERR_MEMORY; *out is NULL then. The
 * caller destroys. */
enum um_status um_compare_measurements_make(struct um_context *context, const char *name,
                                            const struct um_compare_row *row, size_t count,
                                            struct um_compare_measurements **out);

#endif
