/* Private to thermal/: parts filled with tetrahedra. */
#ifndef UMBRA_THERMAL_SOLID_IMPL_H
#define UMBRA_THERMAL_SOLID_IMPL_H

#include "thermal/builder_impl.h"

/* Linear tetrahedron: conductances [W/K] of the edges 01 02 03 12 13 23 for conductivity k
 * [W/m/K], -k V grad(N_i) . grad(N_j); returns the volume V [m^3]. */
double um_thermal_solid_element(const struct um_vec3 corner[4], double k, double out[6]);

/* Nodes, capacities and conduction of one part that is solid. */
enum um_status um_thermal_solid_assemble(struct um_thermal_builder *b, size_t part);

#endif
