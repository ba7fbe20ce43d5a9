/* A table of positions. */
#ifndef UMBRA_ORBIT_TRAJECTORY_TABLE_IMPL_H
#define UMBRA_ORBIT_TRAJECTORY_TABLE_IMPL_H

#include "base/core/context.h"
#include "base/core/vec.h"

struct um_orbit_table {
  char *path;
  size_t n;
  double *t;         /* t_tai [s], ascending, shape [n] */
  struct um_vec3 *r; /* GCRS [m], shape [n] */
  struct um_vec3 *v; /* [m/s], shape [n] */
};

enum um_status um_orbit_table_state(struct um_context *context, const struct um_orbit_table *table,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v);
void um_orbit_table_clear(struct um_context *context, struct um_orbit_table *table);
/* Read and check the CSV of um_orbit_trajectory_create_table; the caller clears the table, after an
 * error too. */
enum um_status um_orbit_table_read(struct um_context *context, const char *path,
                                   struct um_orbit_table *table);
/* Period of the osculating ellipse in the first row [s]; NaN when it is open. */
double um_orbit_table_period(const struct um_orbit_table *table);

#endif
