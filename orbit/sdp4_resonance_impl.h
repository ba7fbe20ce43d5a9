/* Resonance with the geopotential in SDP4. */
#ifndef UMBRA_ORBIT_SDP4_RESONANCE_IMPL_H
#define UMBRA_ORBIT_SDP4_RESONANCE_IMPL_H

#include "orbit/sdp4_impl.h"

/* Geopotential resonance at epoch, and mean motion and anomaly at t [min]. */
void um_orbit_sdp4_resonance_prepare(const struct um_sgp4_elements *epoch,
                                     const struct um_sgp4_secular *secular,
                                     struct um_sdp4_deep *deep);
void um_orbit_sdp4_resonance_at(const struct um_sdp4_deep *deep,
                                const struct um_sgp4_elements *epoch, double argp_dot, double t,
                                struct um_sgp4_elements *mean);

#endif
