/* Where an integration stops and how far it may step between.
 *
 * Where the loads jump or kink hard (eclipse edges, repeated grid times) the integration ends
 * exactly and starts anew, so no step straddles an edge. Between stops a step is at most
 * MAX_STEP_INTERVALS grid intervals long, longer ones could pass over a flash of Sun unseen, or as
 * many more as the loads are smooth over (system_smooth.c). */
#include <math.h>

#include "base/core/order.h"
#include "base/core/sort.h"
#include "thermal/solver/integrator_data_impl.h"

#define MAX_STEP_INTERVALS 2.0
#define SHORTEST_SEGMENT   1e-6 /* [s] stops closer than this are one */

/* Edges, jumps of the table and of power histories, and the end, ascending, apart by
 * SHORTEST_SEGMENT. */
enum um_status um_thermal_integrator_stops(struct um_thermal_integrator *integrator,
                                           double duration)
{
  const struct um_thermal_system *system = integrator->system;
  const struct um_irradiation_loads *loads = system->loads;
  size_t room = 1 + (loads == NULL ? 0 : loads->nedge + loads->ntime), count = 0;
  room += um_thermal_system_heat_stops(system, NULL);
  UM_TRY(um_core_allocate(system->context, room, sizeof(double), &integrator->stop));
  double *stop = integrator->stop;
  for (size_t k = 0; loads != NULL && k < loads->nedge; k++)
    stop[count++] = loads->edge[k] - system->from;
  for (size_t k = 1; loads != NULL && k < loads->ntime; k++)
    if (system->grid[k] <= system->grid[k - 1]) stop[count++] = system->grid[k];
  count += um_thermal_system_heat_stops(system, stop + count);
  UM_TRY(um_core_sort(system->context, stop, count, sizeof *stop, um_core_order_double));
  size_t kept = 0;
  double before = 0.0;
  for (size_t k = 0; k < count; k++)
    if (stop[k] > before + SHORTEST_SEGMENT && stop[k] < duration - SHORTEST_SEGMENT)
      before = stop[kept++] = stop[k];
  stop[kept++] = duration;
  integrator->nstop = kept;
  return UM_OK;
}

/* The longest step [s] in the window; 0: no limit. */
enum um_status um_thermal_integrator_longest_step(struct um_thermal_system *system, double *out)
{
  double longest = 0.0, interval = um_thermal_system_heat_interval(system);
  size_t rows;
  for (size_t k = system->row_low; system->loads != NULL && k < system->row_high; k++)
    longest = fmax(longest, system->grid[k + 1] - system->grid[k]);
  UM_TRY(um_thermal_system_smooth(system, &rows));
  longest *= rows == SIZE_MAX ? 0.0 : (double)rows;
  if (isfinite(interval) && (longest == 0.0 || interval < longest)) longest = interval;
  *out = MAX_STEP_INTERVALS * longest;
  return UM_OK;
}
