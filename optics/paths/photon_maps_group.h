/* Taking kept photons. Private to the rooms of optics/. */
#ifndef UMBRA_OPTICS_PHOTON_MAPS_GROUP_H
#define UMBRA_OPTICS_PHOTON_MAPS_GROUP_H

#include "optics/paths/first_turns_group.h"
#include "optics/paths/photon_maps.h"
#include "optics/paths/photons_group.h"

/* Do the scene's paths have the same mirrors, instants and numbers as those that are kept? Geometry
 * and view are the same for who asks. */
bool um_optics_photon_maps_are_compatible(const struct um_optics_photon_maps *maps,
                                          const struct um_optics_scene *scene,
                                          const struct um_optics_spectra *spectra);
/* Photons of an instant, in place of um_optics_photons_trace; there is room for them. */
void um_optics_photon_maps_take(const struct um_optics_photon_maps *maps, size_t time,
                                struct um_optics_photons *photons);

/* Which paths of the instant meet something; lent by the maps. */
const struct um_optics_first_turns *
um_optics_photon_maps_turns(const struct um_optics_photon_maps *maps, size_t time);

#endif
