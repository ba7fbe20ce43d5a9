/* Kinds of orbits. Private to orbit/. */
#ifndef UMBRA_ORBIT_TRAJECTORY_IMPL_H
#define UMBRA_ORBIT_TRAJECTORY_IMPL_H

#include "orbit/sgp4.h"
#include "orbit/trajectory.h"

/* Two-body ellipse, or a circle of any rate. */
struct um_orbit_conic {
  struct um_vec3 p, q; /* unit, GCRS: toward perigee (epoch point), and 90 deg ahead */
  double a, e;         /* [m], [1] */
  double rate;         /* mean motion [rad/s] */
  double m0;           /* mean anomaly at the epoch [rad] */
  double epoch;        /* t_tai [s] */
};

/* Eccentric anomaly [rad] of M = E - e sin E, 0 <= e < 1, any M; to the last bits of M.
 * UM_ERR_NUMERIC when it does not converge (NaN). */
enum um_status um_orbit_kepler_solve(struct um_context *context, double mean_anomaly, double e,
                                     double *eccentric_anomaly);
enum um_status um_orbit_conic_state(struct um_context *context, const struct um_orbit_conic *conic,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v);

struct um_orbit_table {
  char *path;
  size_t n;
  double *t;         /* t_tai [s], ascending, shape [n] */
  struct um_vec3 *r; /* GCRS [m], shape [n] */
  struct um_vec3 *v; /* [m/s], shape [n] */
};

#define UM_ORBIT_NEAREST  6e6  /* [m] from the geocentre: the smallest Earth of a scenario */
#define UM_ORBIT_FARTHEST 1e12 /* [m] as far as an observer may be */

enum um_status um_orbit_table_state(struct um_context *context, const struct um_orbit_table *table,
                                    double t_tai, struct um_vec3 *r, struct um_vec3 *v);
void um_orbit_table_clear(struct um_context *context, struct um_orbit_table *table);
/* Read and check the CSV of um_orbit_trajectory_create_table; the caller clears the table, after an
 * error too. */
enum um_status um_orbit_table_read(struct um_context *context, const char *path,
                                   const struct um_orbit_earth_orientation *orientation,
                                   struct um_orbit_table *table);
/* Rows of an ephemeris message into an empty table, as um_orbit_message_read has it; orientation:
 * of frames that turn, NULL: zero. UM_ERR_INPUT naming `name`, line and what is accepted. */
enum um_status um_orbit_oem_read(struct um_context *context, const char *name,
                                 const struct um_orbit_earth_orientation *orientation, char *text,
                                 size_t length, bool *is, struct um_orbit_table *table);
/* Period of the osculating ellipse in the first row [s]; NaN when it is open. */
double um_orbit_table_period(const struct um_orbit_table *table);

enum trajectory_kind {
  TRAJECTORY_TLE,
  TRAJECTORY_KEPLER,
  TRAJECTORY_CIRCULAR,
  TRAJECTORY_TABLE,
  TRAJECTORY_FIXED,
  TRAJECTORY_NONE
};

struct um_orbit_trajectory {
  struct um_context *context; /* owns the memory */
  enum trajectory_kind kind;
  double period;                                 /* [s] */
  double shift;                                  /* [s] see um_orbit_trajectory_shift */
  struct um_orbit_sgp4 **sgp4;                   /* TLE: [nset] */
  double *epochs;                                /* TLE: [nset] t_tai [s], rising */
  size_t nset;                                   /* TLE */
  double epoch;                                  /* TLE: of the set that was asked for */
  struct um_orbit_earth_orientation orientation; /* TLE */
  struct um_orbit_conic conic;                   /* KEPLER, CIRCULAR */
  struct um_orbit_table table;                   /* TABLE */
  struct um_vec3 fixed;                          /* FIXED: GCRS [m] */
};

#endif
