/* Surfaces that lie in one place and look the same way: neither hides the other, so that light and
 * heat count twice there. Faces that look at each other, as of boxes that touch, are a contact and
 * not meant; nor is a part inside of another one, which is hidden. */
#ifndef UMBRA_GEOMETRY_COINCIDENT_H
#define UMBRA_GEOMETRY_COINCIDENT_H

#include "geometry/geometry.h"

struct um_geometry_coincidence {
  uint32_t part[2]; /* ascending; the same one twice: a mesh that has a face twice */
  double area;      /* of each, sides that look the same way summed [m^2] */
};
struct um_geometry_coincidences {
  struct um_geometry_coincidence *pair; /* [n] the largest area first */
  size_t n;
  bool all; /* else too many facets stand too close, and the areas are the least there is */
};

/* Faces nearer to each other than 1e-5 of the satellite's diagonal, which is what rays tell apart
 * (visibility.c), of parts that do not move against each other. Parts with nothing in common
 * that is wider than that have seams, and are left out. n log n where few facets overlap.
 * UM_ERR_MEMORY, UM_ERR_CANCELLED. The caller destroys. Test: geometry/coincident. */
enum um_status um_geometry_coincidences_create(struct um_context *context,
                                               const struct um_geometry *geometry,
                                               struct um_geometry_coincidences **out);
void um_geometry_coincidences_destroy(struct um_context *context,
                                      struct um_geometry_coincidences **coincidences);

#endif
