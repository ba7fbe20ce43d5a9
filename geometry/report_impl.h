/* Figures of a mesh. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_REPORT_IMPL_H
#define UMBRA_GEOMETRY_REPORT_IMPL_H

#include "geometry/patch_impl.h"
#include "geometry/topology_impl.h"

struct um_geometry_report um_geometry_report_compute(const struct um_geometry_patch *patch,
                                                     const struct um_geometry_edges *edges);

#endif
