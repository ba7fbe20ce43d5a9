/* Sunlight that mirrors throw, kept: the photons of every instant (photons_group.h), for many light
 * curves of scenes that differ in temperatures and in how much surfaces reflect; and which paths
 * meet something (first_turns_group.h). */
#ifndef UMBRA_OPTICS_PHOTON_MAPS_H
#define UMBRA_OPTICS_PHOTON_MAPS_H

#include "optics/radiance/optics.h"

/* What a light curve of the scene would trace in these bands; no temperature is looked at. *out
 * NULL: there is nothing to keep, as nothing is traced between surfaces or they age; or too much,
 * above 256 MiB. UM_ERR_INPUT, UM_ERR_MEMORY, UM_ERR_LIBRARY, UM_ERR_CANCELLED. The caller
 * destroys. */
enum um_status um_optics_photon_maps_create(struct um_context *context,
                                            const struct um_optics_scene *scene,
                                            const struct um_optics_band *bands, size_t nband,
                                            struct um_optics_photon_maps **out);
/* Accepts NULL, sets NULL. */
void um_optics_photon_maps_destroy(struct um_context *context, struct um_optics_photon_maps **maps);

#endif
