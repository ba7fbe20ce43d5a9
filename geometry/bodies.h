/* Bodies of a part: closed shells that do not touch each other. */
#ifndef UMBRA_GEOMETRY_BODIES_H
#define UMBRA_GEOMETRY_BODIES_H

#include "geometry/geometry.h"

/* Areas of the bodies of a closed part [m^2], in the order of their first facets; none of a part
 * that is not closed. A shell that looks inward is a hollow of a body, no body. The caller frees
 * *area. UM_ERR_MEMORY. Test: geometry/coincident. */
enum um_status um_geometry_bodies(struct um_context *context, const struct um_geometry *geometry,
                                  size_t part, double **area, size_t *n);

#endif
