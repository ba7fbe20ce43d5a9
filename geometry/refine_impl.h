/* Meshes made finer. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_REFINE_IMPL_H
#define UMBRA_GEOMETRY_REFINE_IMPL_H

#include "geometry/patch_impl.h"

/* Bisect longest edges until none is longer than facet_size [m]; conforming. */
enum um_status um_geometry_refine(struct um_geometry_patch *patch, const char *part,
                                  double facet_size);

#endif
