/* Measurements into a file. */
#ifndef UMBRA_COMPARE_WRITE_H
#define UMBRA_COMPARE_WRITE_H

#include "evidence/measurements/set.h"

/* Write the same format (used by synthetic measurements): whole or not at all, beside `path` under
 * a temporary name and then renamed. Optional columns appear where a row has something to say.
 * Times to the millisecond, or the microsecond where a time is not a whole millisecond; numbers
 * with the fewest digits that read back as the same double; temperatures in K, those below
 * UM_COMPARE_COLD as temperature_K. UM_ERR_IO; UM_ERR_NUMERIC for a value
 * that the reader would refuse as not finite. */
enum um_status um_compare_measurements_write(struct um_context *context,
                                             const struct um_compare_measurements *measurements,
                                             const char *path);
/* The same with a line of comment at its head: "# NOTE". NULL: none. */
enum um_status
um_compare_measurements_write_noted(struct um_context *context,
                                    const struct um_compare_measurements *measurements,
                                    const char *note, const char *path);

#endif
