/* Effects that a model may use: the built-in ones and those of shared objects, from the scenario's
 * files, then from those of the command line. */
#include "effects/effects.h"
#include "model/model_impl.h"

enum um_status um_model_build_effect_files(struct um_context *context, struct um_model *model,
                                           const struct um_model_options *options)
{
  const struct um_mark *at = &model->scenario->at;
  const char *const *file = model->scenario->effect_files.items;
  UM_TRY(um_effects_registry_create(context, &model->registry));
  for (size_t i = 0; i < model->scenario->effect_files.count; i++) {
    const char *path;
    UM_TRY(um_model_resolve(context, model, at, file[i], &path));
    UM_TRY(um_model_blame(context, at, "effect_files",
                          um_effects_registry_load(context, model->registry, path)));
  }
  for (size_t i = 0; options != NULL && i < options->neffect_file; i++) {
    enum um_status status =
        um_effects_registry_load(context, model->registry, options->effect_files[i]);
    if (status == UM_OK) continue;
    if (status != UM_ERR_MEMORY) um_core_message_prefix(context, "--effect-file");
    return status;
  }
  return UM_OK;
}

size_t um_model_effects_count(const struct um_model *model)
{
  return um_effects_registry_count(model->registry);
}

const struct um_effect *um_model_effects_at(const struct um_model *model, size_t index)
{
  return um_effects_registry_at(model->registry, index);
}

const struct um_effect *um_model_effects_find(const struct um_model *model, const char *name)
{
  return um_effects_registry_find(model->registry, name);
}
