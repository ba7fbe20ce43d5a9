/* Private to thermal/network/: walls as shells. */
#ifndef UMBRA_THERMAL_SHELL_IMPL_H
#define UMBRA_THERMAL_SHELL_IMPL_H

#include "thermal/network/builder_impl.h"

/* Linear triangle: conductances [W/K] between the corners, out[e] opposite corner e, for in-plane
 * conductance kt [W/K]: kt cot(angle e) / 2. */
void um_thermal_shell_element(const struct um_vec3 corner[3], double kt, double out[3]);
/* Nodes, capacities and conduction of the walls of one part. */
enum um_status um_thermal_shell_assemble(struct um_thermal_builder *b, size_t part);

#endif
