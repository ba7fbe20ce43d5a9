/* Pictures of the satellite at an observation. */
#include <string.h>

#include "model/model.h"

size_t um_model_band_find(const struct um_model *model, const char *name)
{
  for (size_t b = 0; b < model->nband; b++)
    if (strcmp(model->band[b].name, name) == 0) return b;
  return (size_t)-1;
}

enum um_status um_model_picture(struct um_context *context, const struct um_model *model,
                                const struct um_model_trace *trace,
                                const struct um_model_result *result, size_t k, size_t band,
                                int width, int samples_per_pixel, struct um_optics_image **out)
{
  *out = NULL;
  if (!model->has_observer)
    return um_core_fail(context, UM_ERR_INPUT, "%s: a picture needs an observer",
                        model->scenario->at.file);
  size_t instant = k * trace->nsub + trace->nsub / 2;
  size_t row = trace->load_row[instant] * trace->loads->nsurface;
  struct um_optics_scene scene = {.geometry = model->geometry,
                                  .environment = &model->environment,
                                  .samples = &trace->sample[instant],
                                  .material = model->material,
                                  .adjustment = model->adjustment,
                                  .temperature = result->surface_temperature + k * result->nsurface,
                                  .albedo = trace->loads->albedo + row,
                                  .view_factor = trace->loads->view_factor + row};
  struct um_optics_image_options options = {.width = width,
                                            .samples_per_pixel = samples_per_pixel,
                                            .up_gcrs = um_vec3_unit(trace->sample[instant].r)};
  return um_optics_image_render(context, &scene, 0, &model->band[band], &options, out);
}
