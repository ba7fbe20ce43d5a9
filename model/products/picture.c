/* Pictures of the satellite at an observation. */
#include "model/products/picture.h"

#include "model/build/aging_group.h"
#include "model/build/model.h"
#include "model/build/timeline.h"
#include "model/run/run_optics_group.h"
#include "optics/image/surfaces.h"

/* Up is away from the Earth. */
static struct um_optics_image_options options_of(const struct um_environment_sample *sample,
                                                 int width, int samples_per_pixel)
{
  return (struct um_optics_image_options){
      .width = width, .samples_per_pixel = samples_per_pixel, .up_gcrs = um_vec3_unit(sample->r)};
}

enum um_status um_model_picture_estimate(struct um_context *context, const struct um_model *model,
                                         double t_tai, size_t band, int width,
                                         int samples_per_pixel, struct um_optics_image_cost *out)
{
  struct um_environment_sample sample;
  struct um_orbit_look look;
  UM_TRY(um_model_sample_seen(context, model, t_tai, &sample, &look));
  const struct um_optics_scene scene = {
      .geometry = model->geometry, .environment = &model->environment, .samples = &sample};
  const struct um_optics_image_options options = options_of(&sample, width, samples_per_pixel);
  return um_optics_image_estimate(context, &scene, 0, &model->band[band], 1, &options, out);
}

/* The scene of observation k, at the middle of its exposure; *aged is its adjustment, which the
 * caller frees. */
static enum um_status scene_of(struct um_context *context, const struct um_model *model,
                               const struct um_model_tables *tables,
                               const struct um_model_result *result, size_t k,
                               struct um_materials_adjustment **aged, struct um_optics_scene *out)
{
  size_t instant = k * tables->nsub + tables->nsub / 2;
  size_t row = tables->load_row[instant] * tables->seen->nsurface;
  *aged = NULL;
  if (!model->has_observer)
    return um_core_fail(context, UM_ERR_INPUT, "%s: a picture needs an observer",
                        model->scenario->at.file);
  UM_TRY(um_model_materials_over(context, model, &tables->sample[instant], 1, aged));
  *out = (struct um_optics_scene){
      .geometry = model->geometry,
      .creases = model->creases,
      .environment = &model->environment,
      .samples = &tables->sample[instant],
      .material = model->material,
      .adjustment = *aged != NULL ? *aged : model->adjustment,
      .temperature = result->surface_temperature + k * result->nsurface,
      .albedo = tables->seen->albedo + row,
      .view_factor = tables->seen->view_factor + row,
      .interreflection_samples = um_model_paths(model, tables),
      .brightness = tables->seen->brightness == NULL ? NULL : tables->seen->brightness + row};
  return UM_OK;
}

enum um_status um_model_picture(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables,
                                const struct um_model_result *result, size_t k, size_t band,
                                size_t nband, int width, int samples_per_pixel,
                                struct um_optics_image **out)
{
  struct um_materials_adjustment *aged;
  struct um_optics_scene scene;
  *out = NULL;
  UM_TRY(scene_of(context, model, tables, result, k, &aged, &scene));
  struct um_optics_image_options options = options_of(scene.samples, width, samples_per_pixel);
  enum um_status status =
      um_optics_image_render(context, &scene, 0, &model->band[band], nband, &options, out);
  um_core_free(context, aged);
  return status;
}

enum um_status um_model_surface_radiance(struct um_context *context, const struct um_model *model,
                                         const struct um_model_tables *tables,
                                         const struct um_model_result *result, size_t k,
                                         double *out)
{
  struct um_materials_adjustment *aged;
  struct um_optics_scene scene;
  UM_TRY(scene_of(context, model, tables, result, k, &aged, &scene));
  enum um_status status = um_optics_surface_radiance(context, &scene, 0, tables->view,
                                                     k * tables->nsub + tables->nsub / 2,
                                                     model->band, model->nband, out);
  um_core_free(context, aged);
  return status;
}
