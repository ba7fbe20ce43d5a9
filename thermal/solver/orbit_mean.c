/* Where the periodic state of a model moves when the model moves. Over an orbit that repeats, the
 * mean of every node's balance is 0. With M_i^4 the mean of T_i^4 of node i and loads <Q_i>,
 *
 *   P_i + <Q_i> + sum_j K_ij (M_j - M_i) + sum_j s R_ij (M_j^4 - M_i^4)
 *       - s R_i,space (M_i^4 - T_space^4) = residual_i,
 *
 * where residual_i, small, is what temperatures do within the orbit: the mean that radiates is
 * above the one that conducts. The residual of a model whose M is known serves its neighbours,
 * whose orbits vary alike: their M follows from a steady balance, a thousandth of an orbit's
 * integration, and with it where slow nodes start. What fast nodes do is not asked here. */
#include <string.h>

#include "thermal/solver/solve.h"
#include "thermal/solver/steady_impl.h"

#define ROWS 512 /* of the loads that a mean is made of, at most */

/* Means over the orbit into what holds at the system's time 0. Mechanisms stand as they do at the
 * start: what they change otherwise is in the residual. */
static enum um_status loads_hold(struct um_thermal_system *system, double period)
{
  struct um_context *context = system->context;
  const double *grid = system->grid;
  size_t n = system->n, nheld = system->emission_held != NULL ? n + system->nemission : 0;
  size_t last = 0;
  double *sum = NULL, *held = NULL;
  if (system->loads == NULL) return UM_OK;
  while (last + 1 < system->loads->ntime && grid[last + 1] <= period) last++;
  UM_TRY(um_core_allocate(context, n + nheld, sizeof *sum, &sum));
  held = sum + n;
  size_t stride = last / ROWS + 1;
  double before = 0.0;
  um_thermal_system_window(system, 0.0, period);
  for (size_t k = 0; k <= last; k += stride) {
    double after = k + stride <= last ? 0.5 * (grid[k] + grid[k + stride]) : period;
    double w = (after - before) / period; /* half way to the rows beside it */
    before = after;
    um_thermal_system_loads_at(system, grid[k]);
    for (size_t i = 0; i < n; i++) sum[i] += w * system->now.q[i];
    for (size_t i = 0; i < nheld; i++) held[i] += w * system->emission_held[i];
  }
  for (size_t i = 0; i < n; i++) system->now.q[i] = sum[i];
  for (size_t i = 0; i < nheld; i++) system->emission_held[i] = held[i];
  system->now.t = 0.0;
  um_core_free(context, sum);
  return UM_OK;
}

/* Power histories likewise, into what nodes make at all times. */
static void sources_hold(struct um_thermal_system *system, double period)
{
  for (size_t k = 0; k < system->nsource; k++) {
    const struct um_thermal_network_source *source = system->source[k].source;
    double mean = 0.0;
    for (size_t i = 0; i < ROWS; i++)
      mean += um_thermal_source_power(source, system->from + ((double)i + 0.5) / ROWS * period);
    for (size_t j = 0; j < source->at.n; j++)
      system->power[source->at.node[j]] += source->at.weight[j] * mean / ROWS;
  }
  system->nsource = 0;
}

/* The steady system of the orbit's means at temperatures mean[nnode]. */
static enum um_status system_make(struct um_context *context,
                                  const struct um_thermal_network *network,
                                  const struct um_irradiation_loads *loads,
                                  const struct um_thermal_solve_options *options, double from,
                                  double period, const double *mean, struct um_thermal_system **out)
{
  UM_TRY(um_thermal_system_create(context, network, loads, options, mean, from, UM_SYSTEM_STEADY,
                                  out));
  enum um_status status = loads_hold(*out, period);
  if (status != UM_OK) um_thermal_system_destroy(out);
  if (status != UM_OK) return status;
  sources_hold(*out, period);
  return UM_OK;
}

enum um_status um_thermal_orbit_mean_residual(struct um_context *context,
                                              const struct um_thermal_network *network,
                                              const struct um_irradiation_loads *loads,
                                              const struct um_thermal_solve_options *options,
                                              double from, double period, const double *mean,
                                              double *residual)
{
  enum um_status status;
  struct um_thermal_system *system = NULL;
  double *y = NULL;
  UM_CHECK(system_make(context, network, loads, options, from, period, mean, &system));
  UM_CHECK(um_core_allocate(context, 2 * system->nunknown, sizeof *y, &y));
  double *rate = y + system->nunknown;
  for (size_t k = 0; k < system->nunknown; k++) y[k] = mean[system->node[k]];
  um_thermal_system_state_set(system, 0.0, y); /* of a steady system no node is eliminated */
  um_thermal_system_rate(system, rate);
  memset(residual, 0, system->n * sizeof *residual);
  for (size_t k = 0; k < system->nunknown; k++) residual[system->node[k]] = rate[k];
done:
  um_core_free(context, y);
  um_thermal_system_destroy(&system);
  return status;
}

enum um_status um_thermal_orbit_mean_solve(struct um_context *context,
                                           const struct um_thermal_network *network,
                                           const struct um_irradiation_loads *loads,
                                           const struct um_thermal_solve_options *options,
                                           double from, double period, const double *residual,
                                           double *mean)
{
  struct um_thermal_system *system = NULL;
  UM_TRY(system_make(context, network, loads, options, from, period, mean, &system));
  enum um_status status = um_thermal_steady_solve(system, residual, mean);
  um_thermal_system_destroy(&system);
  return status;
}
