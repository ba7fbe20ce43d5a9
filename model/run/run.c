/* One run in both bands on geometry tables. */
#include "model/run/run.h"

#include <math.h>
#include <string.h>

#include "model/run/mesh_error.h"
#include "model/run/parts_impl.h"
#include "model/run/run_optics_group.h"
#include "model/run/thermal_solution.h"
#include "optics/lightcurve/adapt.h"

/* Surface and node temperatures of the observations, means over the exposure. */
static enum um_status keep_temperatures(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        const struct um_model_heat_run *run,
                                        struct um_model_result *r)
{
  r->nsurface = um_geometry_mesh(model->geometry)->nsurface;
  r->nnode = run->history->nnode;
  UM_TRY(um_core_allocate(context, tables->nobs * r->nsurface, sizeof(double),
                          &r->surface_temperature));
  UM_TRY(um_core_allocate(context, tables->nobs * r->nnode, sizeof(double), &r->node_temperature));
  double w = 1.0 / (double)tables->nsub;
  for (size_t i = 0; i < tables->nobs * tables->nsub; i++) {
    size_t k = i / tables->nsub;
    const double *node = run->history->temperature + (i + (run->before ? 1 : 0)) * r->nnode;
    for (size_t s = 0; s < r->nsurface; s++)
      r->surface_temperature[k * r->nsurface + s] += w * run->surface[i * r->nsurface + s];
    for (size_t j = 0; j < r->nnode; j++) r->node_temperature[k * r->nnode + j] += w * node[j];
  }
  return UM_OK;
}

/* More points where the scenario asks for a relative error. */
static enum um_status adapt(struct um_context *context, const struct um_model *model,
                            const struct um_model_heat_run *run, struct um_model_tables *tables)
{
  double asked = model->scenario->optics->relative_error;
  struct um_optics_scene scene = {0};
  struct um_optics_adaptation did;
  if (isnan(asked) || tables->view == NULL) return UM_OK;
  UM_TRY(um_model_scene_make(context, model, tables, run->surface, &scene));
  enum um_status status =
      um_optics_adapt(context, &scene, model->band, model->nband, asked, tables->view, &did);
  um_model_scene_release(context, &scene);
  if (status != UM_OK) return status;
  um_core_log(
      context, UM_LOG_INFO,
      "optics.relative_error %g: %.0f points per facet in the mean, %d at most; %.3g times the "
      "paths between surfaces",
      asked, did.points, did.most, did.paths);
  if (did.missed > 0)
    um_core_log(context, UM_LOG_WARNING,
                "optics.relative_error %g asks for more than %d points per facet, or 64 times "
                "optics.interreflection_samples, at %zu of %zu instants, where the error is up to "
                "%.2g",
                asked, UM_OPTICS_SAMPLES_MAX, did.missed, tables->view->ntime, did.largest);
  return UM_OK;
}

static enum um_status run_of(struct um_context *context, const struct um_model *model,
                             struct um_model_tables *tables, bool stated,
                             struct um_model_result **out)
{
  struct um_model_thermal_solution *heat = NULL;
  *out = NULL;
  UM_TRY(um_model_thermal_solution_create(context, model, tables, NULL, 1.0, &heat));
  enum um_status status = adapt(context, model, &heat->run, tables);
  if (status == UM_OK) status = um_model_run_with(context, model, tables, heat, out);
  if (status == UM_OK && stated)
    status = um_model_mesh_error(context, model, tables, heat, *out, &(*out)->mesh);
  if (status == UM_OK && model->scenario->thermal->outside_range == UM_RANGE_WARNING)
    status = um_model_check_record_ranges(context, model, tables, *out);
  if (status != UM_OK) um_model_result_destroy(context, out);
  um_model_thermal_solution_destroy(context, &heat);
  return status;
}

enum um_status um_model_run(struct um_context *context, const struct um_model *model,
                            struct um_model_tables *tables, struct um_model_result **out)
{
  return run_of(context, model, tables, false, out);
}

enum um_status um_model_run_stated(struct um_context *context, const struct um_model *model,
                                   struct um_model_tables *tables, struct um_model_result **out)
{
  return run_of(context, model, tables, true, out);
}

enum um_status um_model_run_with(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result **out)
{
  UM_TRY(um_model_run_observed(context, model, tables, heat, out));
  enum um_status status = um_model_run_heat(context, model, tables, heat, *out);
  if (status != UM_OK) um_model_result_destroy(context, out);
  return status;
}

/* All but the light and what is made of it. */
static enum um_status run_dark(struct um_context *context, const struct um_model *model,
                               const struct um_model_tables *tables,
                               const struct um_model_thermal_solution *heat,
                               struct um_model_result *result)
{
  const struct um_model_heat_run *run = &heat->run;
  result->nobs = tables->nobs;
  result->audit = run->history->audit;
  result->audit_error = run->history->audit_error;
  result->audit_limit = um_thermal_history_audit_limit(run->history, &heat->solver.options);
  result->periodic_distance = heat->periodic_distance;
  result->steps = run->history->steps;
  result->rhs_evaluations = run->history->rhs_evaluations;
  result->jacobians = run->history->jacobians;
  UM_TRY(keep_temperatures(context, model, tables, run, result));
  if (model->scenario->thermal->outside_range == UM_RANGE_ERROR)
    UM_TRY(um_model_check_record_ranges(context, model, tables, result));
  return um_model_run_histories(context, model, tables, heat, result);
}

enum um_status um_model_run_behind(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const struct um_optics_lightcurve *light,
                                   struct um_model_result **out)
{
  struct um_model_result *result = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *result, &result));
  enum um_status status = run_dark(context, model, tables, heat, result);
  if (status == UM_OK) status = um_model_run_optics(context, model, tables, light, result);
  if (status != UM_OK) um_model_result_destroy(context, &result);
  *out = result;
  return status;
}

enum um_status um_model_run_observed(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_thermal_solution *heat,
                                     struct um_model_result **out)
{
  enum um_status status;
  struct um_optics_lightcurve *light = NULL;
  struct um_model_result *result = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *result, &result));
  UM_CHECK(run_dark(context, model, tables, heat, result));
  UM_CHECK(um_model_run_light(context, model, tables, heat, &light));
  UM_CHECK(um_model_run_optics(context, model, tables, light, result));
done:
  um_optics_lightcurve_destroy(context, &light);
  if (status != UM_OK) um_model_result_destroy(context, &result);
  *out = result;
  return status;
}

enum um_status um_model_run_places(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   struct um_model_result **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->nobs = tables->nobs;
  enum um_status status = um_model_run_histories(context, model, tables, heat, *out);
  if (status != UM_OK) um_model_result_destroy(context, out);
  return status;
}
