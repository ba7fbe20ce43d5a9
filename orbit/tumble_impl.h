/* A rigid body of three moments of inertia that nothing turns. Private to orbit/. */
#ifndef UMBRA_ORBIT_TUMBLE_IMPL_H
#define UMBRA_ORBIT_TUMBLE_IMPL_H

#include <stdbool.h>

#include "base/core/context.h"
#include "base/core/vec.h"

#define UM_TUMBLE_PANELS 64

struct um_orbit_tumble {
  bool steady;             /* the rate is along the momentum: it turns about it */
  struct um_vec3 rate;     /* at the reference time, body axes [rad/s] */
  struct um_quat q;        /* GCRS to body at the reference time */
  struct um_quat to_axes;  /* body to principal axes c, b, a */
  struct um_quat momentum; /* GCRS to a frame whose z is the momentum */
  double inertia[3];       /* about c, b, a, over the largest [1] */
  double amplitude[3];     /* of the rate about c, b, a [rad/s] */
  double sense;            /* of the rate about b [1] */
  double n, start;         /* u = start + n (t - at) [rad/s], [1] */
  double m1, quarter;      /* parameter, K [1] */
  double size, energy;     /* momentum L and 2 E, of that inertia [rad/s], [rad^2/s^2] */
  int panels;
  double turned[UM_TUMBLE_PANELS + 1]; /* chi(u) at the panels' ends, 0 to K [rad] */
  double chi_start;                    /* at the reference time [rad] */
};

/* inertia: xx, yy, zz, xy, xz, yz of the tensor in body axes [any unit]; rate [rad/s].
 * UM_ERR_INPUT: moments that no body has, no rate, a rate on the separatrix. */
enum um_status um_orbit_tumble_make(struct um_context *context, const double inertia[6],
                                    struct um_vec3 rate, struct um_quat q,
                                    struct um_orbit_tumble *out);
/* `since` the reference time [s]. rate (may be NULL): in body axes [rad/s]. */
struct um_quat um_orbit_tumble_at(const struct um_orbit_tumble *tumble, double since,
                                  struct um_vec3 *rate);
/* Of the polhode: the rate comes again in body axes [s]; infinite for a steady one. */
double um_orbit_tumble_period(const struct um_orbit_tumble *tumble);
double um_orbit_tumble_fastest(const struct um_orbit_tumble *tumble); /* [rad/s] */

#endif
