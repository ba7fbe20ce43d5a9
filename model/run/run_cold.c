/* Light of instants that stand alone, and what air and instrument make of it. */
#include "model/run/run.h"
#include "model/run/run_optics_group.h"

enum um_status um_model_run_cold_light(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables,
                                       struct um_optics_lightcurve **out)
{
  enum um_status status;
  struct um_optics_scene scene = {0};
  double *cold = NULL;
  size_t n = tables->nobs * tables->nsub * um_geometry_mesh(model->geometry)->nsurface;
  *out = NULL;
  if (tables->view == NULL) return UM_OK;
  UM_CHECK(um_core_allocate(context, n, sizeof *cold, &cold));
  for (size_t i = 0; i < n; i++) cold[i] = UM_MODEL_COLD;
  UM_CHECK(um_model_scene_make(context, model, tables, cold, &scene));
  status = um_optics_lightcurve_compute(context, &scene, model->band, model->nband, out);
  um_model_scene_release(context, &scene);
done:
  um_core_free(context, cold);
  return status;
}

enum um_status um_model_run_cold(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables, struct um_model_result **out)
{
  enum um_status status;
  struct um_optics_lightcurve *light = NULL;
  struct um_model_result *result = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *result, &result));
  result->nobs = tables->nobs;
  UM_CHECK(um_model_run_cold_light(context, model, tables, &light));
  UM_CHECK(um_model_run_optics(context, model, tables, light, result));
  *out = result;
  result = NULL;
done:
  um_optics_lightcurve_destroy(context, &light);
  um_model_result_destroy(context, &result);
  return status;
}
