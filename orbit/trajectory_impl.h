/* What the files behind um_orbit_trajectory share. */
#ifndef UMBRA_ORBIT_TRAJECTORY_IMPL_H
#define UMBRA_ORBIT_TRAJECTORY_IMPL_H

#include "orbit/kepler_impl.h"
#include "orbit/sgp4.h"
#include "orbit/trajectory.h"
#include "orbit/trajectory_table_impl.h"

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
  struct um_orbit_sgp4 *sgp4;                    /* TLE */
  double epoch;                                  /* TLE: t_tai [s] */
  struct um_orbit_earth_orientation orientation; /* TLE */
  struct um_orbit_conic conic;                   /* KEPLER, CIRCULAR */
  struct um_orbit_table table;                   /* TABLE */
  struct um_vec3 fixed;                          /* FIXED: GCRS [m] */
};

#endif
