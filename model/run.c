/* One run in both bands on a traced timeline. */
#include <math.h>
#include <string.h>

#include "model/run_impl.h"

/* Surface and node temperatures of the observations, means over the exposure. */
static enum um_status keep_temperatures(struct um_context *context, const struct um_model *model,
                                        const struct um_model_trace *trace,
                                        const struct um_model_heat_run *run,
                                        struct um_model_result *r)
{
  r->nsurface = um_geometry_mesh(model->geometry)->nsurface;
  r->nnode = run->history->nnode;
  UM_TRY(um_core_allocate(context, trace->nobs * r->nsurface, sizeof(double),
                          &r->surface_temperature));
  UM_TRY(um_core_allocate(context, trace->nobs * r->nnode, sizeof(double), &r->node_temperature));
  double w = 1.0 / (double)trace->nsub;
  for (size_t i = 0; i < trace->nobs * trace->nsub; i++) {
    size_t k = i / trace->nsub;
    const double *node = run->history->temperature + (i + (run->before ? 1 : 0)) * r->nnode;
    for (size_t s = 0; s < r->nsurface; s++)
      r->surface_temperature[k * r->nsurface + s] += w * run->surface[i * r->nsurface + s];
    for (size_t j = 0; j < r->nnode; j++) r->node_temperature[k * r->nnode + j] += w * node[j];
  }
  return UM_OK;
}

enum um_status um_model_run(struct um_context *context, const struct um_model *model,
                            const struct um_model_trace *trace, struct um_model_result **out)
{
  struct um_model_heat *heat = NULL;
  *out = NULL;
  UM_TRY(um_model_heat_create(context, model, trace, NULL, 1.0, &heat));
  enum um_status status = um_model_run_with(context, model, trace, heat, out);
  um_model_heat_destroy(context, &heat);
  return status;
}

enum um_status um_model_run_with(struct um_context *context, const struct um_model *model,
                                 const struct um_model_trace *trace,
                                 const struct um_model_heat *heat, struct um_model_result **out)
{
  enum um_status status;
  const struct um_model_heat_run *run = &heat->run;
  struct um_model_result *result = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *result, &result));
  result->nobs = trace->nobs;
  result->audit = run->history->audit;
  result->audit_error = run->history->audit_error;
  result->periodic_drift = heat->periodic_drift;
  result->steps = run->history->steps;
  result->rhs_evaluations = run->history->rhs_evaluations;
  result->jacobians = run->history->jacobians;
  UM_CHECK(keep_temperatures(context, model, trace, run, result));
  UM_CHECK(um_model_run_places(context, model, trace, run, result));
  UM_CHECK(um_model_run_optics(context, model, trace, run, result));
done:
  if (status != UM_OK) um_model_result_destroy(context, &result);
  *out = result;
  return status;
}

double um_model_result_intensity(const struct um_model_result *result, size_t k, size_t band,
                                 int mechanism)
{
  const double *at =
      result->intensity + (k * result->nband + band) * result->nmaterial * UM_MECHANISM_COUNT;
  double sum = 0.0;
  for (size_t m = 0; m < result->nmaterial; m++)
    for (int i = 0; i < UM_MECHANISM_COUNT; i++)
      if (mechanism < 0 || i == mechanism) sum += at[m * UM_MECHANISM_COUNT + (size_t)i];
  return sum;
}

void um_model_result_destroy(struct um_context *context, struct um_model_result **result)
{
  if (result == NULL || *result == NULL) return;
  struct um_model_result *r = *result;
  for (size_t i = 0; r->place != NULL && i < r->nplace; i++) {
    um_core_free(context, r->place[i].name);
    um_core_free(context, r->place[i].mean);
    um_core_free(context, r->place[i].minimum);
    um_core_free(context, r->place[i].maximum);
  }
  um_core_free(context, r->place);
  um_core_free(context, r->heat);
  um_core_free(context, r->irradiance);
  um_core_free(context, r->magnitude_ab);
  um_core_free(context, r->intensity);
  um_core_free(context, r->standard_error);
  um_core_free(context, r->spectral);
  um_core_free(context, r->wavelength);
  um_core_free(context, r->bin_width);
  um_core_free(context, r->bin_band);
  um_core_free(context, r->surface_temperature);
  um_core_free(context, r->node_temperature);
  um_core_free(context, r);
  *result = NULL;
}
