/* Evaluation of the heat balance at a state: net heat, rate of change (equation in system_build.c).
 */
#include "thermal/solver/system_group.h"

#include <math.h>

void um_thermal_system_node_powers(struct um_thermal_system *system, size_t i)
{
  double t = system->temperature[i], a = fabs(t);
  system->cube[i] = a * a * a;
  system->power4[i] = system->cube[i] * t;
  um_thermal_system_emission_set(system, i);
}

void um_thermal_system_powers(struct um_thermal_system *system)
{
  for (size_t i = 0; i < system->n; i++) um_thermal_system_node_powers(system, i);
}

double um_thermal_system_node_heat(const struct um_thermal_system *system, size_t node)
{
  double heat = system->power[node] + system->now.q[node];
  if (system->made != NULL) heat += system->made[node];
  if (system->exchange != NULL) heat += system->exchange->gain[node];
  heat -= system->space[node] * (system->power4[node] - system->space4);
  double exchange = 0.0;
  for (size_t e = system->start[node]; e < system->start[node + 1]; e++) {
    exchange += um_thermal_system_link_heat(system, e, node, system->other[e]);
  }
  return heat + exchange;
}

void um_thermal_system_rate(const struct um_thermal_system *system, double *rate)
{
  for (size_t k = 0; k < system->nunknown; k++) {
    size_t i = system->node[k];
    rate[k] = um_thermal_system_node_heat(system, i) / system->capacity[i];
  }
}

double um_thermal_system_content(const struct um_thermal_system *system, const double *y)
{
  double sum = 0.0;
  for (size_t k = 0; k < system->nunknown; k++) sum += system->capacity[system->node[k]] * y[k];
  return sum;
}
