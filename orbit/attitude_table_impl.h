/* A table of quaternions. */
#ifndef UMBRA_ORBIT_ATTITUDE_TABLE_IMPL_H
#define UMBRA_ORBIT_ATTITUDE_TABLE_IMPL_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/finals.h"

struct um_orbit_attitude_table {
  char *path;
  size_t n;
  double *t;         /* t_tai [s], ascending, shape [n] */
  struct um_quat *q; /* GCRS to body, unit, shape [n] */
};

#define UM_ORBIT_ATTITUDE_NORM 1e-3 /* of |q| from 1, rounding of short columns */

/* Rows of an attitude message into an empty table, as um_orbit_message_read has it; orientation: of
 * frames that turn, NULL: zero. UM_ERR_INPUT naming `name`, line and what is accepted. */
enum um_status um_orbit_aem_read(struct um_context *context, const char *name,
                                 const struct um_orbit_earth_orientation *orientation, char *text,
                                 size_t length, bool *is, struct um_orbit_attitude_table *table);
enum um_status um_orbit_attitude_table_read(struct um_context *context, const char *path,
                                            const struct um_orbit_earth_orientation *orientation,
                                            double max_gap, struct um_orbit_attitude_table *table);
void um_orbit_attitude_table_clear(struct um_context *context,
                                   struct um_orbit_attitude_table *table);
enum um_status um_orbit_attitude_table_at(struct um_context *context,
                                          const struct um_orbit_attitude_table *table, double t_tai,
                                          struct um_quat *q);
/* Fastest turn between two rows [rad/s]. */
double um_orbit_attitude_table_rate(const struct um_orbit_attitude_table *table);

#endif
