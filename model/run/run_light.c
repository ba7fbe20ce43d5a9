/* Light of a run: what surfaces and their temperatures send to the observer. */
#include "model/run/run_light.h"

#include "model/run/run_optics_group.h"

enum um_status um_model_run_light(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables,
                                  const struct um_model_thermal_solution *heat,
                                  struct um_optics_lightcurve **out)
{
  struct um_optics_scene scene = {0};
  *out = NULL;
  if (tables->view == NULL) return UM_OK;
  UM_TRY(um_model_scene_make(context, model, tables, heat->run.surface, &scene));
  enum um_status status =
      um_optics_lightcurve_compute(context, &scene, model->band, model->nband, out);
  um_model_scene_release(context, &scene);
  return status;
}
