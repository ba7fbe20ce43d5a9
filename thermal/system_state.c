/* The state of a heat balance: temperatures of the unknowns, and all that follows from them at a
 * time. */
#include "thermal/system_impl.h"

bool um_thermal_system_state_set(struct um_thermal_system *system, double t, const double *y)
{
  um_thermal_system_loads_at(system, t);
  for (size_t k = 0; k < system->nunknown; k++) system->temperature[system->node[k]] = y[k];
  um_thermal_system_powers(system);
  if (system->made != NULL) um_thermal_system_heat_make(system, t);
  return um_thermal_system_clusters_solve(system);
}
