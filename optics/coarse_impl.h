/* Bands in few bins: 0.5 % of an error, whose cost then does not depend on theirs. */
#ifndef UMBRA_OPTICS_COARSE_IMPL_H
#define UMBRA_OPTICS_COARSE_IMPL_H

#include "optics/optics.h"

#define UM_OPTICS_COARSE_BINS 16 /* of a band, at most */

/* coarse[nband], whose filters stand in transmission[nband][UM_OPTICS_COARSE_BINS]. */
void um_optics_coarse_bands(const struct um_optics_band *bands, size_t nband,
                            struct um_optics_band *coarse, double *transmission);

#endif
