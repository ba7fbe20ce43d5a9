/* The parts of SGP4/SDP4 put together. */
#ifndef UMBRA_ORBIT_SGP4_IMPL_H
#define UMBRA_ORBIT_SGP4_IMPL_H

#include "orbit/sdp4_impl.h"
#include "orbit/sgp4.h"

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
