/* Light that leaves one surface and is reflected by another, any number of times. */
#ifndef UMBRA_OPTICS_INTERREFLECTION_GROUP_H
#define UMBRA_OPTICS_INTERREFLECTION_GROUP_H

#include "optics/paths/paths_impl.h"

struct um_optics_photons; /* photons_group.h */

/* Mean radiance per bin that a surface of the posed scene sends to the observer by this way, over
 * the share of its points that the observer sees (seen < 1: traced) times that share;
 * work->reflected holds it [W/m^2/sr/m], work->band_variance the variance of each band's radiance
 * by the choice of paths; that by the choice of photons is theirs to say when all surfaces are
 * done. False, and nothing is touched: nothing stands before the surface. photons: of this instant.
 */
bool um_optics_interreflection(const struct um_optics_paths *paths,
                               struct um_optics_photons *photons, size_t surface, double seen);

#endif
