/* Two-body motion. */
#ifndef UMBRA_ORBIT_KEPLER_IMPL_H
#define UMBRA_ORBIT_KEPLER_IMPL_H

#include "base/core/context.h"
#include "base/core/vec.h"

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

#endif
