/* Mean elements of SGP4/SDP4, and how gravity and drag move them. Units of the theory: minutes,
 * radians, Earth radii of WGS-72.
 * STR3: Hoots & Roehrich 1980, Spacetrack Report 3. V06: Vallado et al. 2006, AIAA 2006-6753. */
#ifndef UMBRA_ORBIT_SGP4_SECULAR_IMPL_H
#define UMBRA_ORBIT_SGP4_SECULAR_IMPL_H

#include <math.h>
#include <stdbool.h>

#include "base/core/constants.h"

/* WGS-72, V06 table 2 */
#define SGP4_MU     398600.8    /* [km^3/s^2] */
#define SGP4_RADIUS 6378.135    /* [km] */
#define SGP4_J2     0.001082616 /* [1] */
#define SGP4_J3     (-0.00000253881)
#define SGP4_J4     (-0.00000165597)

/* k_e = sqrt(mu) in Earth radii^1.5 per minute */
static inline double um_sgp4_ke(void)
{
  return 60.0 / sqrt(SGP4_RADIUS * SGP4_RADIUS * SGP4_RADIUS / SGP4_MU);
}

/* Mean elements. */
struct um_sgp4_elements {
  double n;                /* mean motion [rad/min] */
  double e;                /* [1] */
  double i, raan, argp, m; /* [rad] */
};

/* Secular gravity and drag of the near-Earth theory. */
struct um_sgp4_secular {
  double n0, a0;                    /* un-Kozai'd mean motion [rad/min], semi-major axis [er] */
  double m_dot, argp_dot, raan_dot; /* [rad/min] */
  double raan_drag;                 /* of t^2 [rad/min^2] */
  double bstar, c1, c4, c5, d2, d3, d4, t2, t3, t4, t5; /* drag polynomials, STR3 section 6 */
  double argp_drag, m_drag;  /* omega cofactor [rad/min], anomaly cofactor [rad] */
  double eta, cube0, sin_m0; /* eta, (1 + eta cos M0)^3, sin M0 */
  bool truncated;            /* perigee below 220 km, or deep space: no terms above t^2 */
};

void um_orbit_sgp4_secular_prepare(const struct um_sgp4_elements *tle, double bstar,
                                   struct um_sgp4_secular *secular);
/* Mean elements after gravity and drag at t [min]; drag of axis, eccentricity and mean longitude is
 * given apart, because deep space puts its own terms between. */
struct um_sgp4_drag {
  double axis, e, longitude; /* factor, decrease, [rad] per n0 */
};
void um_orbit_sgp4_secular_at(const struct um_sgp4_elements *epoch,
                              const struct um_sgp4_secular *secular, double t,
                              struct um_sgp4_elements *mean, struct um_sgp4_drag *drag);

#endif
