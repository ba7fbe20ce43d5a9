/* Steady balances: of an instant, and of an orbit's mean. */
#include "model/run/balance.h"

#include <math.h>
#include <string.h>

#include "base/core/interpolation.h"
#include "model/run/solver_options_impl.h"
#include "thermal/solver/flat.h"
#include "thermal/solver/solve.h"

/* What a node takes in whatever its temperature [W]. */
static double absorbed(const struct um_thermal_heat *heat)
{
  return heat->solar + heat->albedo + heat->planet + heat->internal;
}

/* Add weight times what every node takes in at a row of the loads. temperature: any. */
static enum um_status add_row(struct um_context *context, const struct um_thermal_network *network,
                              const struct um_thermal_solve_options *options,
                              const struct um_irradiation_loads *loads, size_t row, double weight,
                              const double *temperature, struct um_thermal_heat *heat, double *sum)
{
  size_t n = um_thermal_network_nodes(network);
  UM_TRY(um_core_stop_check(context, "heat was averaged over an orbit"));
  UM_TRY(
      um_thermal_heat_of_nodes(context, network, loads, options, loads->t[row], temperature, heat));
  for (size_t i = 0; i < n; i++) sum[i] += weight * absorbed(&heat[i]);
  return UM_OK;
}

/* mean[nnode] [W] over [from, from + period] by trapezoids; the last one is cut at its end. */
static enum um_status average(struct um_context *context, const struct um_thermal_network *network,
                              const struct um_thermal_solve_options *options,
                              const struct um_irradiation_loads *loads, double from, double period,
                              const double *temperature, double *mean)
{
  enum um_status status = UM_OK;
  size_t n = um_thermal_network_nodes(network);
  struct um_thermal_heat *heat = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *heat, &heat));
  for (size_t k = 0; k < loads->ntime; k++) {
    /* share of row k: half of both intervals beside it */
    double low = k > 0 ? loads->t[k - 1] : loads->t[k], at = loads->t[k];
    double high = k + 1 < loads->ntime ? loads->t[k + 1] : at, end = from + period, weight = 0.0;
    if (low < end) weight += 0.5 * (fmin(at, end) - fmax(low, from));
    if (at < end) weight += 0.5 * (fmin(high, end) - fmax(at, from));
    if (!(weight > 0.0)) continue;
    UM_CHECK(
        add_row(context, network, options, loads, k, weight / period, temperature, heat, mean));
  }
done:
  um_core_free(context, heat);
  return status;
}

/* Row of the loads at the first observed instant, or the one before it. */
static size_t first_row(const struct um_model_tables *tables)
{
  const struct um_irradiation_loads *loads = tables->loads;
  if (loads == tables->seen) return tables->load_row[0];
  return loads->ntime > 1 ? um_core_interval_find(loads->t, loads->ntime, tables->sample[0].t_tai)
                          : 0;
}

enum um_status um_model_balance_steady(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables, double *temperature)
{
  struct um_model_solver_options solver = {0};
  enum um_status status = um_model_solver_options_make(context, model, tables, NULL, &solver);
  double change = status == UM_OK ? INFINITY : 0.0;
  for (int round = 1; change > UM_MODEL_SAME_EMITTANCE; round++) {
    UM_CHECK(um_thermal_solve_steady(context, model->body->network, tables->loads,
                                     first_row(tables), &solver.options, NULL, temperature));
    UM_CHECK(um_model_solver_options_renew(context, model, tables, temperature,
                                           UM_MODEL_SAME_EMITTANCE, round, &solver, &change));
  }
done:
  um_model_solver_options_clear(context, &solver);
  return status;
}

static bool has_orbit(const struct um_model_tables *tables)
{
  const struct um_irradiation_loads *loads = tables->loads;
  return !tables->points && !isnan(tables->period) &&
         loads->t[loads->ntime - 1] >= tables->t_start + tables->period - 1e-3;
}

/* Temperatures of the balance, what every node takes in for it, and how it was solved. */
struct balance {
  struct um_model_solver_options solver;
  double *power, *temperature; /* [nnode] [W], [K] */
};

static void balance_clear(struct um_context *context, struct balance *balance)
{
  UM_FREE(context, balance->power, balance->temperature);
  um_model_solver_options_clear(context, &balance->solver);
}

/* Of an orbit's mean, or of the first observation where there is none. */
static enum um_status balance_solve(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables, struct balance *out)
{
  enum um_status status;
  const struct um_irradiation_loads *loads = tables->loads;
  const struct um_thermal_network *network = model->body->network;
  const struct um_thermal_solve_options *options = &out->solver.options;
  size_t n = um_thermal_network_nodes(network);
  struct um_thermal_heat *heat = NULL;
  UM_CHECK(um_model_solver_options_make(context, model, tables, NULL, &out->solver));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->power, &out->power));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->temperature, &out->temperature));
  UM_CHECK(um_core_allocate(context, n, sizeof *heat, &heat));
  for (uint32_t i = 0; i < n; i++) out->temperature[i] = um_thermal_network_temperature(network, i);
  if (has_orbit(tables))
    UM_CHECK(average(context, network, options, loads, tables->t_start, tables->period,
                     out->temperature, out->power));
  else
    UM_CHECK(add_row(context, network, options, loads, first_row(tables), 1.0, out->temperature,
                     heat, out->power));
  double change = INFINITY;
  for (int round = 1; change > UM_MODEL_SAME_EMITTANCE; round++) {
    UM_CHECK(um_thermal_solve_powered(context, network, out->power, options, out->temperature));
    UM_CHECK(um_model_solver_options_renew(context, model, tables, out->temperature,
                                           UM_MODEL_SAME_EMITTANCE, round, &out->solver, &change));
  }
done:
  um_core_free(context, heat);
  return status;
}

enum um_status um_model_balance_orbit(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables, double *temperature)
{
  struct balance balance = {0};
  if (!has_orbit(tables))
    return um_core_fail(context, UM_ERR_INPUT,
                        "analysis orbit_mean: no whole orbit is computed; accepted: an orbit, and "
                        "thermal.start: periodic or thermal.orbits_before: 1");
  enum um_status status = balance_solve(context, model, tables, &balance);
  if (status == UM_OK)
    memcpy(temperature, balance.temperature,
           um_thermal_network_nodes(model->body->network) * sizeof *temperature);
  balance_clear(context, &balance);
  return status;
}

enum um_status um_model_balance_network(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        struct um_thermal_network **out)
{
  struct balance balance = {0};
  enum um_status status = balance_solve(context, model, tables, &balance);
  if (status == UM_OK)
    status = um_thermal_flatten(context, model->body->network, balance.power,
                                &balance.solver.options, balance.temperature, out);
  balance_clear(context, &balance);
  return status;
}
