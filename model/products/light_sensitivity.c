/* Light by temperatures that parameters have moved. */
#include "model/products/light_sensitivity.h"

#include "model/products/thermal_sensitivity_impl.h"
#include "model/run/run_optics_group.h"
#include "optics/lightcurve/warmth.h"

struct um_model_light_sensitivity {
  size_t nvalue;    /* of a light curve: instants times bins */
  double *spectral; /* [nmove][nvalue] */
};

enum um_status um_model_light_sensitivity_create(struct um_context *context,
                                                 const struct um_model_thermal_sensitivity *thermal,
                                                 struct um_model_light_sensitivity **out)
{
  enum um_status status;
  const struct um_model_thermal_solution *heat = thermal->heat;
  const struct um_model *model = heat->model;
  const struct um_model_tables *tables = heat->tables;
  struct um_model_light_sensitivity *s = NULL;
  struct um_optics_lightcurve *light = NULL;
  struct um_optics_scene scene = {0};
  *out = NULL;
  if (tables->view == NULL || model->scenario->thermal->temperature_in_optics == 1) return UM_OK;
  UM_TRY(um_model_scene_make(context, model, tables, heat->run.surface, &scene));
  UM_CHECK(um_core_allocate(context, 1, sizeof *s, &s));
  for (size_t b = 0; b < model->nband; b++)
    s->nvalue += tables->nobs * tables->nsub * (size_t)model->band[b].bins;
  UM_CHECK(um_core_allocate(context, thermal->nmove, s->nvalue * sizeof(double), &s->spectral));
  const struct um_optics_warmth warmth = {.n = thermal->nmove,
                                          .warming = um_model_thermal_sensitivity_surfaces,
                                          .user = thermal,
                                          .spectral = s->spectral};
  UM_CHECK(
      um_optics_lightcurve_warmth(context, &scene, model->band, model->nband, &warmth, &light));
  *out = s;
  s = NULL;
done:
  um_optics_lightcurve_destroy(context, &light);
  um_model_scene_release(context, &scene);
  um_model_light_sensitivity_destroy(context, &s);
  return status;
}

void um_model_light_sensitivity_destroy(struct um_context *context,
                                        struct um_model_light_sensitivity **sensitivity)
{
  if (*sensitivity == NULL) return;
  UM_FREE(context, (*sensitivity)->spectral, *sensitivity);
  *sensitivity = NULL;
}

enum um_status um_model_light_move(struct um_context *context,
                                   const struct um_optics_lightcurve *light,
                                   const struct um_model_light_sensitivity *sensitivity,
                                   size_t which, double step, struct um_optics_lightcurve **out)
{
  return um_optics_lightcurve_warmed(
      context, light, sensitivity->spectral + which * sensitivity->nvalue, step, out);
}
