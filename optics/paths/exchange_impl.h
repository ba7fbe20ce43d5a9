/* What of a pose paths go by, and where they begin. Private to optics/paths/. */
#ifndef UMBRA_OPTICS_EXCHANGE_IMPL_H
#define UMBRA_OPTICS_EXCHANGE_IMPL_H

#include "geometry/visibility.h"
#include "optics/radiance/posed_scene_group.h"

/* nsample: paths of a surface at an instant. */
enum um_status um_optics_exchange_create(struct um_context *context,
                                         const struct um_geometry_mesh *mesh,
                                         const struct um_optics_posed_scene *posed, int nsample,
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

#endif
