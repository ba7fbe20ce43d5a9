/* What deep space adds to SGP4, in the units of the theory (sgp4_secular_impl.h). */
#ifndef UMBRA_ORBIT_SDP4_IMPL_H
#define UMBRA_ORBIT_SDP4_IMPL_H

#include "orbit/sgp4_secular_impl.h"

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

#endif
