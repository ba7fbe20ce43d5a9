/* The time column of a table of positions or quaternions. */
#ifndef UMBRA_ORBIT_TIME_COLUMN_IMPL_H
#define UMBRA_ORBIT_TIME_COLUMN_IMPL_H

#include "base/core/csv.h"

/* The column time_utc of a table, strictly ascending, shape [rows]; the caller
 * frees. UM_ERR_INPUT names file, line and what is accepted; at least `minimum` rows. */
enum um_status um_orbit_time_column(struct um_context *context, const struct um_core_csv *csv,
                                    size_t minimum, double **t_tai);
/* UM_ERR_INPUT where `what`, as "a position", is wanted beyond the times t [n] of a table. */
enum um_status um_orbit_time_within(struct um_context *context, const char *path, const char *what,
                                    double t_tai, const double *t, size_t n);

#endif
