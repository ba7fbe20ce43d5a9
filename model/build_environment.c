/* From the scenario's environment and effects to the configuration of Sun and Earth. */
#include "model/build_environment_impl.h"

#include "core/constants.h"
#include "model/effects_impl.h"
#include "model/scenario_environment_impl.h"

enum um_status um_model_build_environment(struct um_context *context, struct um_model *model)
{
  struct um_effect_use use;
  um_model_scenario_environment(model->scenario->environment, &model->environment);
  model->sun_frozen = model->scenario->environment->sun == UM_SUN_FROZEN;
  for (size_t i = 0; i < model->neffect; i++) {
    const struct um_model_effect *e = &model->effect[i];
    enum um_status (*turn)(struct um_context *, struct um_environment *) =
        e->off ? e->effect->switch_off : e->effect->switch_on;
    if (turn != NULL) UM_TRY(turn(context, &model->environment));
  }
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.environment != NULL)
      UM_TRY(use.effect->hooks.environment(context, &use, &model->environment));
  return UM_OK;
}
