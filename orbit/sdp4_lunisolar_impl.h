/* Sun and Moon in SDP4. */
#ifndef UMBRA_ORBIT_SDP4_LUNISOLAR_IMPL_H
#define UMBRA_ORBIT_SDP4_LUNISOLAR_IMPL_H

#include "orbit/sdp4_impl.h"

/* Third-body terms at epoch; days since 1949-12-31 0h UTC. */
void um_orbit_sdp4_lunisolar_prepare(const struct um_sgp4_elements *epoch, double days_1950,
                                     struct um_sdp4_deep *deep);
/* Add the long-period periodics at t [min] (Lyddane's form below 0.2 rad of inclination). */
void um_orbit_sdp4_lunisolar_periodics(const struct um_sdp4_deep *deep, double t,
                                       struct um_sgp4_elements *mean);

#endif
