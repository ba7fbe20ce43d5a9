/* Emission to space. Of node i, with r_l the ratio of law l at the node's temperature,
 *
 *   space_i(T_i) = what is constant + sum_l c_il r_l(T_i),
 *
 * c_il the emission of its surfaces under that law at the emittance they state. Where surfaces age
 * the sums are those of the instant. Without laws and ageing space is made once. */
#include <string.h>

#include "base/core/constants.h"
#include "thermal/solver/load_row_impl.h"
#include "thermal/solver/system_group.h"

/* Surfaces' shares in rows per node, with one entry for each law that a node has. */
static enum um_status collect(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  size_t n = system->n, room = 3 * network->nsurface, *start = NULL;
  UM_TRY(um_core_allocate(context, room, sizeof *system->emission, &system->emission));
  UM_TRY(um_core_allocate(context, room, sizeof(uint32_t), &system->emission_of));
  UM_TRY(um_core_allocate(context, n + 1, sizeof *start, &system->emission_start));
  start = system->emission_start;
  for (size_t i = 0; i < room; i++) {
    uint32_t node = network->surface[i / 3].node[i % 3];
    system->emission_of[i] = UM_THERMAL_NONE;
    if (network->attached[i / 3] && network->surface[i / 3].law != NULL &&
        node != UM_THERMAL_SPACE) {
      system->emission_of[i] = node; /* its entry, soon */
      start[node + 1]++;
    }
  }
  for (size_t i = 0; i < n; i++) start[i + 1] += start[i];
  for (size_t i = 0; i < room; i++) {
    uint32_t node = system->emission_of[i];
    if (node == UM_THERMAL_NONE) continue;
    const struct um_thermal_surface_law *law = network->surface[i / 3].law;
    size_t e = start[node];
    while (e < start[node + 1] && system->emission[e] != NULL && system->emission[e] != law) e++;
    system->emission[e] = law;
    system->emission_of[i] = (uint32_t)e;
  }
  system->nemission = start[n];
  return UM_OK;
}

void um_thermal_system_emission_row(const struct um_thermal_system *system, size_t row,
                                    double *held)
{
  const struct um_thermal_network *network = system->network;
  const struct um_thermal_aging *aging = system->loads == NULL ? NULL : system->options.aging;
  memset(held, 0, (system->n + system->nemission) * sizeof *held);
  for (size_t r = 0; r < network->nradiator; r++)
    if (network->radiator[r].b == UM_THERMAL_SPACE)
      held[network->radiator[r].a] += UM_STEFAN_BOLTZMANN * network->radiator[r].value;
  for (size_t s = 0; s < network->nsurface; s++)
    for (int k = 0; k < 3 && network->attached[s]; k++) {
      uint32_t node = network->surface[s].node[k], entry = UM_THERMAL_NONE;
      if (node == UM_THERMAL_SPACE) continue;
      if (system->nemission > 0) entry = system->emission_of[3 * s + (size_t)k];
      held[entry == UM_THERMAL_NONE ? node : system->n + entry] +=
          um_thermal_load_row_emission(network, aging, row, s, k);
    }
}

enum um_status um_thermal_system_emission_build(struct um_thermal_system *system)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  bool laws = false, ages = system->loads != NULL && system->options.aging != NULL;
  for (size_t s = 0; s < network->nsurface; s++)
    laws = laws || (network->attached[s] && network->surface[s].law != NULL);
  if (laws) UM_TRY(collect(system));
  UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->space));
  if (laws) UM_TRY(um_core_allocate(context, system->n, sizeof(double), &system->space_slope));
  if (!laws && !ages) {
    um_thermal_system_emission_row(system, 0, system->space);
    return UM_OK;
  }
  UM_TRY(um_core_allocate(context, system->n + system->nemission, sizeof(double),
                          &system->emission_held));
  um_thermal_system_emission_row(system, 0, system->emission_held);
  for (size_t i = 0; i < system->n; i++) um_thermal_system_emission_set(system, i);
  return UM_OK;
}

void um_thermal_system_emission_set(struct um_thermal_system *system, size_t i)
{
  if (system->emission_held == NULL) return;
  system->space[i] = system->emission_held[i];
  if (system->space_slope == NULL) return;
  system->space_slope[i] = 0.0;
  for (size_t e = system->emission_start[i]; e < system->emission_start[i + 1]; e++) {
    if (system->emission[e] == NULL) break; /* a node has as many entries as laws */
    double slope, coefficient = system->emission_held[system->n + e];
    double ratio =
        um_thermal_surface_law_emittance(system->emission[e], system->temperature[i], &slope);
    system->space[i] += coefficient * ratio;
    system->space_slope[i] += coefficient * slope;
  }
}
