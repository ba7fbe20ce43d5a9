/* The state of a heat balance: temperatures of the unknowns, and all that follows from them at a
 * time. */
#include "thermal/solver/system_group.h"

#include <math.h>

#define ROUNDS  200
#define SETTLED 1e-13 /* change of what eliminated nodes receive, of all that is received [1] */

/* Eliminated nodes that exchange heat with each other: each group balances at what the others send,
 * and sends; shares below 1 go on from one to the next, so that it settles. */
static bool clusters_settle(struct um_thermal_system *system)
{
  for (int round = 0; round < ROUNDS; round++) {
    if (!um_thermal_system_clusters_solve(system)) return false;
    double size = 0.0, change = um_thermal_system_exchange_make(system);
    for (size_t i = 0; i < system->n; i++) size += fabs(system->exchange->gain[i]);
    if (change <= SETTLED * size) return true;
  }
  return false;
}

static void temperatures_set(struct um_thermal_system *system, const double *y)
{
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    if (system->store == NULL)
      system->temperature[i] = y[k];
    else
      system->temperature[i] =
          um_thermal_system_temperature_of(system, i, y[k], &system->warming[i]);
  }
  um_thermal_system_powers(system);
}

bool um_thermal_system_powers_set(struct um_thermal_system *system, double t, const double *y)
{
  if (system->ncluster > 0) return um_thermal_system_state_set(system, t, y);
  temperatures_set(system, y);
  return true;
}

bool um_thermal_system_state_set(struct um_thermal_system *system, double t, const double *y)
{
  um_thermal_system_loads_at(system, t);
  temperatures_set(system, y);
  if (system->made != NULL) um_thermal_system_heat_make(system, t);
  if (system->exchange == NULL) return um_thermal_system_clusters_solve(system);
  um_thermal_system_exchange_at(system, t);
  um_thermal_system_exchange_make(system);
  if (system->ncluster == 0) return true;
  return clusters_settle(system);
}
