/* Surfaces that nothing stands before. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_HORIZON_IMPL_H
#define UMBRA_GEOMETRY_HORIZON_IMPL_H

#include "geometry/visibility_data_impl.h"

/* Fills visibility->open. */
enum um_status um_geometry_horizon_find(struct um_geometry_visibility *visibility);

#endif
