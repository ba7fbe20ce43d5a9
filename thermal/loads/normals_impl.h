/* Private to thermal/loads/: surfaces that share a normal. */
#ifndef UMBRA_IRRADIATION_NORMALS_IMPL_H
#define UMBRA_IRRADIATION_NORMALS_IMPL_H

#include "geometry/geometry.h"

/* Surfaces of one rigid part with the same normal share what an unobstructed plate gets. */
struct um_irradiation_normals {
  size_t n;
  uint32_t *of;      /* [nsurface] class */
  uint32_t *example; /* [nsurface] of which [n]: a surface of each class */
  uint32_t *order;   /* [nsurface] surfaces, class by class, ascending */
  size_t *begin;     /* [n + 1] first of a class in `order` */
};

/* By the pose. Cleared by the caller, after a failure too. UM_ERR_MEMORY. */
enum um_status um_irradiation_normals_find(struct um_context *context,
                                           const struct um_geometry_mesh *mesh,
                                           const struct um_geometry_pose *pose,
                                           struct um_irradiation_normals *out);
void um_irradiation_normals_clear(struct um_context *context,
                                  struct um_irradiation_normals *normals);

#endif
