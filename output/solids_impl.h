/* Private to output/: tetrahedra of a body. */
#ifndef UMBRA_OUTPUT_SOLIDS_IMPL_H
#define UMBRA_OUTPUT_SOLIDS_IMPL_H

#include "thermal/network/body.h"

/* Vertices of the tetrahedra of all solids of a body. */
size_t um_output_solid_vertices(const struct um_thermal_body *body);

#endif
