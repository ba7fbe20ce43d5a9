/* Creases: how each group of the built parts hangs, from the scenario and from effects. */
#include "model/build/steps_impl.h"

#include "base/core/constants.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"

/* A group's own creases come before its part's, which a group without the part's MLI has not. */
const struct um_scenario_creases *um_model_creases_of(const struct um_scenario_part *part,
                                                      const char *group)
{
  const struct um_scenario_group *own = um_model_group_named(part, group);
  if (own != NULL && own->creases != NULL) return own->creases;
  return own != NULL && own->bare ? NULL : part->creases;
}

static const struct um_scenario_part *part_of(const struct um_model *model,
                                              const struct um_geometry_group *group)
{
  return (const struct um_scenario_part *)model->scenario->parts.items + group->part;
}

/* Is there sheet that could be creased: MLI, or what the scenario says is? */
static bool hangs(const struct um_model *model, const struct um_geometry_group *group)
{
  const struct um_scenario_part *part = part_of(model, group);
  const struct um_scenario_group *own = um_model_group_named(part, group->name);
  if (um_model_creases_of(part, group->name) != NULL) return true;
  if (own != NULL && own->mli != NULL) return true;
  return part->mli != NULL && !(own != NULL && own->bare);
}

static enum um_status group_of(struct um_context *context, const struct um_model *model,
                               const struct um_geometry_group *group,
                               struct um_geometry_creasing *to)
{
  const struct um_scenario_part *part = part_of(model, group);
  const struct um_scenario_creases *from = um_model_creases_of(part, group->name);
  struct um_effect_use use;
  if (from != NULL) {
    double tilt = from->tilt_rms_deg * UM_DEG;
    *to = (struct um_geometry_creasing){tilt * tilt, from->patch_m, (uint64_t)from->seed};
  }
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.creases != NULL)
      UM_TRY(use.effect->hooks.creases(context, &use, part->name, group->name,
                                       hangs(model, group) ? to : NULL));
  return UM_OK;
}

/* A use that would act on nothing is refused. */
static enum um_status check_uses(struct um_context *context, const struct um_model *model)
{
  const struct um_geometry *g = model->geometry;
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);) {
    bool any = use.effect->hooks.creases == NULL;
    for (size_t k = 0; !any && k < um_geometry_group_count(g); k++) {
      const struct um_geometry_group *group = um_geometry_group(g, (uint32_t)k);
      any = um_effect_acts_on_group(&use, um_geometry_part_name(g, group->part), group->name) &&
            hangs(model, group);
    }
    if (!any)
      return um_core_fail(
          context, UM_ERR_INPUT,
          "effect '%s': the part '%s' has no MLI; accepted: a part with MLI, or one "
          "that states creases",
          use.effect->name, use.target);
  }
  return UM_OK;
}

enum um_status um_model_build_creases(struct um_context *context, struct um_model *model)
{
  size_t n = um_geometry_group_count(model->geometry);
  UM_TRY(um_core_allocate(context, n, sizeof *model->creasing, &model->creasing));
  UM_TRY(check_uses(context, model));
  for (size_t g = 0; g < n; g++)
    UM_TRY(group_of(context, model, um_geometry_group(model->geometry, (uint32_t)g),
                    &model->creasing[g]));
  enum um_status status = um_optics_creases_create(context, model->geometry, model->creasing,
                                                   model->material, &model->creases);
  return status == UM_OK ? status : um_model_blame_part(context, model, status);
}
