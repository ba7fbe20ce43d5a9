/* SGP4 and SDP4: secular and periodic terms. Private to orbit/. */
#ifndef UMBRA_ORBIT_SGP4_IMPL_H
#define UMBRA_ORBIT_SGP4_IMPL_H

#include <math.h>
#include <stdbool.h>

#include "base/core/constants.h"
#include "orbit/sgp4.h"

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

/* Periodic terms of one third body, and its own mean motion round the Earth. */
struct um_sdp4_body {
  double m0, n, e; /* mean anomaly at epoch [rad], mean motion [rad/min], eccentricity */
  double e2, e3, i2, i3, l2, l3, l4, gh2, gh3, gh4, h2, h3; /* amplitudes [1], [rad] */
};

/* A resonant geopotential term: amplitude sin(k_argp omega + k_lambda lambda - phase). */
struct um_sdp4_harmonic {
  double amplitude; /* [rad/min^2] */
  double k_argp, k_lambda;
  double phase; /* [rad] */
};

enum um_sdp4_resonance { UM_RESONANCE_NONE, UM_RESONANCE_ONE_DAY, UM_RESONANCE_HALF_DAY };

struct um_sdp4_deep {
  struct um_sdp4_body sun, moon;
  double e_dot, i_dot, m_dot, argp_dot, raan_dot; /* lunisolar secular rates [1/min], [rad/min] */
  enum um_sdp4_resonance resonance;
  struct um_sdp4_harmonic harmonic[10];
  int harmonics;
  double gmst0;      /* Greenwich sidereal angle at epoch [rad] */
  double lambda0;    /* resonance angle at epoch [rad] */
  double lambda_dot; /* its rate less the mean motion [rad/min] */
};

/* Third-body terms at epoch; days since 1949-12-31 0h UTC. */
void um_orbit_sdp4_lunisolar_prepare(const struct um_sgp4_elements *epoch, double days_1950,
                                     struct um_sdp4_deep *deep);
/* Add the long-period periodics at t [min] (Lyddane's form below 0.2 rad of inclination). */
void um_orbit_sdp4_lunisolar_periodics(const struct um_sdp4_deep *deep, double t,
                                       struct um_sgp4_elements *mean);

/* Geopotential resonance at epoch, and mean motion and anomaly at t [min]. */
void um_orbit_sdp4_resonance_prepare(const struct um_sgp4_elements *epoch,
                                     const struct um_sgp4_secular *secular,
                                     struct um_sdp4_deep *deep);
void um_orbit_sdp4_resonance_at(const struct um_sdp4_deep *deep,
                                const struct um_sgp4_elements *epoch, double argp_dot, double t,
                                struct um_sgp4_elements *mean);

struct um_orbit_sgp4 {
  struct um_context *context;    /* owns the memory */
  struct um_sgp4_elements epoch; /* as in the TLE, n un-Kozai'd */
  struct um_sgp4_secular secular;
  bool deep;
  struct um_sdp4_deep deep_space;
};

/* Nodal period [s] from the secular rates: 2 pi / (dM/dt + domega/dt). */
double um_orbit_sgp4_nodal_period(const struct um_orbit_sgp4 *sgp4);

#endif
