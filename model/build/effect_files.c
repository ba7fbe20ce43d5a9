/* Effects that a model may use: the built-in ones and those of shared objects, from the scenario's
 * files, then from those of the command line. A shared object is code that runs inside the program,
 * so a scenario, which may come from anywhere, cannot have one loaded by itself: the command line
 * names the same file, or allows them all. */
#include "model/build/effect_files.h"
#include "model/build/steps_impl.h"

#include <stdlib.h>
#include <string.h>

#include "effects/effects.h"
#include "model/build/messages_group.h"

/* Does the command line name the file that stands at `path`? */
static bool is_named(const struct um_model_options *options, const char *path)
{
  bool named = false;
  char *wanted = realpath(path, NULL);
  for (size_t i = 0; wanted != NULL && !named && i < options->neffect_file; i++) {
    char *given = realpath(options->effect_files[i], NULL);
    named = given != NULL && strcmp(given, wanted) == 0;
    free(given);
  }
  free(wanted);
  return named;
}

enum um_status um_model_build_effect_files(struct um_context *context, struct um_model *model,
                                           const struct um_model_options *options)
{
  const struct um_mark *at = &model->scenario->at;
  const char *const *file = model->scenario->effect_files.items;
  UM_TRY(um_effects_registry_create(context, &model->registry));
  for (size_t i = 0; i < model->scenario->effect_files.count; i++) {
    const char *path;
    UM_TRY(um_model_resolve(context, model, at, file[i], &path));
    if (options == NULL || (!options->allow_effects && !is_named(options, path)))
      return um_model_fail(
          context, at, "effect_files",
          "'%s' is code that would run inside the program; accepted: --allow-effects "
          "on the command line, or --effect-file with that file",
          file[i]);
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

static size_t place_of(const struct um_model *model, const struct um_effect *effect)
{
  size_t i = 0;
  while (i < um_model_effects_count(model) && um_model_effects_at(model, i) != effect) i++;
  return i;
}

static bool comes_before(const struct um_model *model, const struct um_model_effect *a,
                         const struct um_model_effect *b)
{
  if (a->effect != b->effect) return place_of(model, a->effect) < place_of(model, b->effect);
  if (a->target == NULL || b->target == NULL) return a->target == NULL && b->target != NULL;
  return strcmp(a->target, b->target) < 0;
}

void um_model_effects_sort(const struct um_model *model, struct um_model_effect *use, size_t n)
{
  for (size_t i = 1; i < n; i++)
    for (size_t j = i; j > 0 && comes_before(model, &use[j], &use[j - 1]); j--) {
      struct um_model_effect other = use[j];
      use[j] = use[j - 1];
      use[j - 1] = other;
    }
}
