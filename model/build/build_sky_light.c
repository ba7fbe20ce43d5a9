/* The air above the station, whose scattered light stands in the line of sight. */
#include "model/build/steps_impl.h"

#include <math.h>

#include "environment/sky_light.h"

enum um_status um_model_build_sky_light(struct um_context *context, struct um_model *model)
{
  const struct um_environment_clear_sky *sky = &model->environment.sky;
  const struct um_environment_sky_light *had =
      model->origin != NULL ? model->origin->sky_light : NULL;
  double from = INFINITY, to = 0.0;
  if (!sky->present || sky->table != NULL || model->observer.kind != UM_OBSERVER_STATION)
    return UM_OK;
  for (size_t b = 0; b < model->nband; b++) {
    if (!(model->band[b].from < UM_SKY_LIGHT_LONGEST)) continue;
    from = fmin(from, model->band[b].from);
    to = fmax(to, model->band[b].to);
  }
  if (!(to > UM_SKY_LIGHT_SHORTEST)) return UM_OK;
  if (had != NULL &&
      um_environment_sky_light_is_of(had, &model->environment, model->observer.height, from, to)) {
    model->sky_light = model->origin->sky_light;
    return UM_OK;
  }
  return um_environment_sky_light_make(context, &model->environment, model->observer.height, from,
                                       to, &model->sky_light);
}
