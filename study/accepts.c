/* Values that a point may have. Records are files: what they hold is looked at as any input is. */
#include <math.h>

#include "study/accepts.h"
#include "study/study_impl.h"

/* Effects that change readings may take more away than there is; those that are on by default do
 * not. */
static bool changes_readings(const struct um_effect *effect)
{
  return effect != NULL && effect->hooks.observation != NULL && !effect->on_by_default;
}

bool um_study_light_has_sign(const struct um_model *model)
{
  for (size_t i = 0; i < model->neffect; i++)
    if (!model->effect[i].off && changes_readings(model->effect[i].effect)) return true;
  return false;
}

bool um_study_accepts(void *user, const double *parameter, const double *value)
{
  const struct um_study *study = user;
  bool has_sign = um_study_light_has_sign(study->model), same_sight = true;
  (void)parameter;
  for (size_t i = 0; i < study->nbinding; i++) {
    has_sign = has_sign || changes_readings(study->binding[i].effect);
    same_sight = same_sight && !study->moves_geometry[i];
  }
  for (size_t i = 0; i < study->nvalue; i++) {
    switch (study->output[i / study->ntime].kind) {
    case UM_STUDY_TEMPERATURE:
      if (!um_study_is_temperature(value[i])) return false;
      break;
    case UM_STUDY_IRRADIANCE:
      if (!um_study_is_light(value[i], has_sign)) return false;
      if (same_sight && isnan(value[i]) != isnan(study->nominal[i])) return false;
      break;
    case UM_STUDY_MAGNITUDE:
      if (isinf(value[i])) return false;
      break;
    }
  }
  return true;
}
