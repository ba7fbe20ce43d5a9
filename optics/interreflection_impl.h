/* Light that leaves one surface and is reflected by another, once. */
#ifndef UMBRA_OPTICS_INTERREFLECTION_IMPL_H
#define UMBRA_OPTICS_INTERREFLECTION_IMPL_H

#include "optics/radiance_impl.h"
#include "optics/set_impl.h"

/* Cosine-weighted rays from the points of each surface that met another surface: pure geometry,
 * traced once per pose. */
struct um_optics_exchange;

enum um_status um_optics_exchange_create(struct um_context *context,
                                         const struct um_geometry_mesh *mesh,
                                         const struct um_optics_set *set, int nsample,
                                         struct um_optics_exchange **out);
void um_optics_exchange_destroy(struct um_context *context, struct um_optics_exchange **exchange);
/* False: no ray of this surface met anything, so it reflects no light of others. */
bool um_optics_exchange_has(const struct um_optics_exchange *exchange, size_t surface);

/* Mean radiance per bin that a surface of the set sends to the observer by this way, over the share
 * of its points that the observer sees (seen < 1: traced) times that share; work->reflected holds
 * it [W/m^2/sr/m], work->band_variance the variance of each band's radiance. */
void um_optics_interreflection(const struct um_optics_spectra *spectra,
                               const struct um_optics_scene *scene,
                               const struct um_optics_instant *instant,
                               const struct um_optics_set *set, size_t time, size_t surface,
                               double seen, struct um_optics_work *work);

#endif
