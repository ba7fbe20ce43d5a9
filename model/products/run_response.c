/* Derivatives of a run: of temperatures by small heat along the history that was found, and of
 * light by the temperature of surfaces. */
#include "model/products/run_response.h"

#include <string.h>

#include "model/run/run.h"
#include "model/run/thermal_solution_group.h"

enum um_status um_model_thermal_solution_response(struct um_context *context,
                                                  const struct um_model_thermal_solution *heat,
                                                  const struct um_thermal_pulse *pulse,
                                                  size_t npulse, double tolerance,
                                                  um_thermal_sensitivity_take *take, void *user)
{
  const struct um_thermal_forcings forcings = {.pulse = pulse, .npulse = npulse};
  const struct um_thermal_sensitivity_options how = {.tolerance = tolerance};
  const struct um_model_tables *tables = heat->tables;
  size_t ninstant = tables->nobs * tables->nsub;
  const struct um_thermal_history *history = heat->run.history;
  const double *first = history->temperature + (heat->run.before ? history->nnode : 0);
  double *times = NULL;
  if (tables->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "answers to heat: observations that stand alone have no heat to follow");
  UM_TRY(um_core_allocate(context, ninstant, sizeof *times, &times));
  for (size_t i = 0; i < ninstant; i++) times[i] = tables->sample[i].t_tai;
  enum um_status status = um_thermal_sensitivity(context, heat->model->body->network, tables->loads,
                                                 &heat->solver.options, first, times[0], times,
                                                 ninstant, &forcings, &how, take, user);
  um_core_free(context, times);
  return status;
}

enum um_status um_model_run_warmer(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const double *offset, struct um_model_result **out)
{
  struct um_model_thermal_solution warmer = *heat;
  size_t nsurface = um_geometry_mesh(model->geometry)->nsurface;
  size_t ninstant = tables->nobs * tables->nsub;
  *out = NULL;
  UM_TRY(um_core_allocate(context, ninstant * nsurface, sizeof(double), &warmer.run.surface));
  for (size_t i = 0; i < ninstant; i++)
    for (size_t s = 0; s < nsurface; s++)
      warmer.run.surface[i * nsurface + s] = heat->run.surface[i * nsurface + s] + offset[s];
  enum um_status status = um_model_run_with(context, model, tables, &warmer, out);
  um_core_free(context, warmer.run.surface);
  return status;
}
