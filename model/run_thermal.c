/* Temperatures: periodic or isothermal start, then through the observations. */
#include <math.h>
#include <string.h>

#include "model/run_impl.h"

#define PERIODIC_TOLERANCE 0.01 /* of the repeating state [K] */

static struct um_thermal_solve_options options_of(const struct um_model *model)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  const struct um_scenario_thermal *thermal = model->scenario->thermal;
  options.relative_tolerance = thermal->relative_tolerance;
  options.absolute_tolerance = thermal->absolute_tolerance_K;
  options.space_temperature = thermal->space_temperature_K;
  options.albedo_on = model->environment.albedo_on;
  options.planet_on = model->environment.planet_on;
  return options;
}

/* Start temperatures into the network, as the scenario wants them. */
static enum um_status start(struct um_context *context, const struct um_model *model,
                            const struct um_model_trace *trace,
                            const struct um_thermal_solve_options *options,
                            struct um_model_result *result)
{
  enum um_status status;
  struct um_thermal_network *network = model->body->network;
  double *t0 = NULL;
  result->periodic_drift = NAN;
  if (model->scenario->thermal->start != UM_START_PERIODIC) return UM_OK;
  UM_TRY(um_core_allocate(context, um_thermal_network_nodes(network), sizeof *t0, &t0));
  if (isnan(trace->period))
    UM_CHECK(um_thermal_solve_steady(context, network, trace->loads, 0, options, t0));
  else
    UM_CHECK(um_thermal_solve_periodic(context, network, trace->loads, options, trace->t_start,
                                       trace->period, PERIODIC_TOLERANCE, t0,
                                       &result->periodic_drift));
  um_thermal_network_temperatures_set(network, t0);
done:
  um_core_free(context, t0);
  return status;
}

/* The paper's reduction: every surface of a material at the material's mean temperature. */
static enum um_status to_material_means(struct um_context *context, const struct um_model *model,
                                        size_t ninstant, double *surface)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t nmaterial = um_geometry_material_count(model->geometry);
  double *sum = NULL;
  UM_TRY(um_core_allocate(context, 2 * nmaterial, sizeof *sum, &sum));
  for (size_t i = 0; i < ninstant; i++) {
    double *t = surface + i * mesh->nsurface;
    memset(sum, 0, 2 * nmaterial * sizeof *sum);
    for (size_t s = 0; s < mesh->nsurface; s++) {
      uint32_t m = mesh->surface[s].material;
      double area = mesh->area[mesh->surface[s].facet];
      sum[2 * m] += area * t[s];
      sum[2 * m + 1] += area;
    }
    for (size_t s = 0; s < mesh->nsurface; s++) {
      uint32_t m = mesh->surface[s].material;
      t[s] = sum[2 * m] / sum[2 * m + 1];
    }
  }
  um_core_free(context, sum);
  return UM_OK;
}

enum um_status um_model_run_thermal(struct um_context *context, const struct um_model *model,
                                    const struct um_model_trace *trace,
                                    struct um_model_heat_run *run, struct um_model_result *result)
{
  enum um_status status;
  const struct um_thermal_network *network = model->body->network;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  struct um_thermal_solve_options options = options_of(model);
  size_t ninstant = trace->nobs * trace->nsub;
  double *times = NULL;
  UM_TRY(start(context, model, trace, &options, result));
  UM_CHECK(um_core_allocate(context, ninstant + 1, sizeof *times, &times));
  double before = trace->t_first - trace->period;
  run->before = before >= trace->t_start - 1e-6;
  if (run->before) times[0] = fmax(before, trace->t_start);
  for (size_t i = 0; i < ninstant; i++) times[i + (run->before ? 1 : 0)] = trace->sample[i].t_tai;
  UM_CHECK(um_thermal_solve(context, network, trace->loads, &options, trace->t_start, times,
                            ninstant + (run->before ? 1 : 0), &run->history));
  result->audit = run->history->audit;
  result->audit_error = run->history->audit_error;
  result->steps = run->history->steps;
  result->rhs_evaluations = run->history->rhs_evaluations;
  result->jacobians = run->history->jacobians;
  UM_CHECK(um_core_allocate(context, ninstant * mesh->nsurface, sizeof(double), &run->surface));
  size_t nnode = run->history->nnode;
  for (size_t i = 0; i < ninstant; i++)
    um_thermal_surface_temperatures(network,
                                    run->history->temperature + (i + (run->before ? 1 : 0)) * nnode,
                                    run->surface + i * mesh->nsurface);
  if (model->scenario->thermal->temperature_in_optics == 1)
    UM_CHECK(to_material_means(context, model, ninstant, run->surface));
done:
  um_core_free(context, times);
  return status;
}

void um_model_heat_run_release(struct um_context *context, struct um_model_heat_run *run)
{
  um_thermal_history_destroy(context, &run->history);
  um_core_free(context, run->surface);
  run->surface = NULL;
}
