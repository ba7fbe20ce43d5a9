/* Light that leaves one surface and is reflected by another, any number of times. */
#ifndef UMBRA_OPTICS_INTERREFLECTION_IMPL_H
#define UMBRA_OPTICS_INTERREFLECTION_IMPL_H

#include "optics/radiance_impl.h"
#include "optics/set_impl.h"

#define UM_OPTICS_PATHS 16 /* that are traced together */

/* What of a pose paths go by (paths_impl.h); nsample: paths of a surface at an instant. */
struct um_optics_exchange;
struct um_optics_paths;
struct um_optics_photons; /* photons_impl.h */

enum um_status um_optics_exchange_create(struct um_context *context,
                                         const struct um_geometry_mesh *mesh,
                                         const struct um_optics_set *set, int nsample,
                                         struct um_optics_exchange **out);
void um_optics_exchange_destroy(struct um_context *context, struct um_optics_exchange **exchange);

/* A point of a facet by weights of its corners, and a ray without direction from one by two numbers
 * of [0, 1). */
struct um_vec3 um_optics_facet_point(const struct um_geometry_mesh *mesh,
                                     const struct um_geometry_pose *pose, uint32_t facet,
                                     const double weight[3]);
struct um_geometry_ray um_optics_path_begin(const struct um_geometry_mesh *mesh,
                                            const struct um_geometry_pose *pose, size_t surface,
                                            const double place[2]);

/* Mean radiance per bin that a surface of the set sends to the observer by this way, over the share
 * of its points that the observer sees (seen < 1: traced) times that share; work->reflected holds
 * it [W/m^2/sr/m], work->band_variance the variance of each band's radiance by the choice of paths;
 * that by the choice of photons is theirs to say when all surfaces are done. False, and nothing is
 * touched: nothing stands before the surface. photons: of this instant. */
bool um_optics_interreflection(const struct um_optics_paths *paths,
                               struct um_optics_photons *photons, size_t surface, double seen);

#endif
