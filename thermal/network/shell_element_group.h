/* One element of a wall. Private to the rooms of thermal/. */
#ifndef UMBRA_THERMAL_SHELL_ELEMENT_GROUP_H
#define UMBRA_THERMAL_SHELL_ELEMENT_GROUP_H

#include "base/core/vec.h"

/* Linear triangle: conductances [W/K] between the corners, out[e] opposite corner e, for in-plane
 * conductance kt [W/K]: kt cot(angle e) / 2. */
void um_thermal_shell_element(const struct um_vec3 corner[3], double kt, double out[3]);

#endif
