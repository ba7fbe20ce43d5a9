/* Derivatives of a run: of temperatures by small heat along the history that was found, and of
 * light by the temperature of surfaces. */
#include "model/run_response.h"

#include <string.h>

#include "model/run.h"
#include "model/thermal_solution_impl.h"

enum um_status um_model_thermal_solution_response(struct um_context *context,
                                                  const struct um_model_thermal_solution *heat,
                                                  const struct um_thermal_response_source *source,
                                                  size_t nsource,
                                                  const struct um_thermal_response_options *how,
                                                  um_thermal_response_take *take, void *user)
{
  enum um_status status;
  const struct um_model_precomputed *precomputed = heat->precomputed;
  struct um_thermal_network *network = heat->model->body->network;
  size_t ninstant = precomputed->nobs * precomputed->nsub, n = um_thermal_network_nodes(network);
  const double *first = heat->run.history->temperature + (heat->run.before ? n : 0);
  double *built = NULL, *times = NULL;
  if (precomputed->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "answers to heat: observations that stand alone have no heat to follow");
  UM_CHECK(um_core_allocate(context, n, sizeof *built, &built));
  UM_CHECK(um_core_allocate(context, ninstant, sizeof *times, &times));
  for (size_t i = 0; i < n; i++) built[i] = um_thermal_network_temperature(network, (uint32_t)i);
  for (size_t i = 0; i < ninstant; i++) times[i] = precomputed->sample[i].t_tai;
  um_thermal_network_temperatures_set(network, first);
  status = um_thermal_response(context, network, precomputed->loads, &heat->setting.options,
                               times[0], times, ninstant, source, nsource, how, take, user);
  um_thermal_network_temperatures_set(network, built);
done:
  um_core_free(context, built);
  um_core_free(context, times);
  return status;
}

enum um_status um_model_run_warmer(struct um_context *context, const struct um_model *model,
                                   const struct um_model_precomputed *precomputed,
                                   const struct um_model_thermal_solution *heat,
                                   const double *offset, struct um_model_result **out)
{
  struct um_model_thermal_solution warmer = *heat;
  size_t nsurface = um_geometry_mesh(model->geometry)->nsurface;
  size_t ninstant = precomputed->nobs * precomputed->nsub;
  *out = NULL;
  UM_TRY(um_core_allocate(context, ninstant * nsurface, sizeof(double), &warmer.run.surface));
  for (size_t i = 0; i < ninstant; i++)
    for (size_t s = 0; s < nsurface; s++)
      warmer.run.surface[i * nsurface + s] = heat->run.surface[i * nsurface + s] + offset[s];
  enum um_status status = um_model_run_with(context, model, precomputed, &warmer, out);
  um_core_free(context, warmer.run.surface);
  return status;
}
