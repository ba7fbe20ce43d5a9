/* Tilted patches: how those of each group of the built parts lie, from the scenario and from
 * effects. A group is of sheet, which hangs, or a panel. One struct and one key of fields serve
 * both; they have words of their own, `creases` and `flatness`, as a diagnosis names what it finds
 * by the effect that acts on it. */
#include "model/build/steps_impl.h"

#include "base/core/constants.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"

static const struct um_scenario_part *part_of(const struct um_model *model,
                                              const struct um_geometry_group *group)
{
  return (const struct um_scenario_part *)model->scenario->parts.items + group->part;
}

/* A group's own creases come before its part's, which a group without the part's MLI has not. */
static const struct um_scenario_creases *creases_of(const struct um_scenario_part *part,
                                                    const struct um_scenario_group *own)
{
  if (own != NULL && own->creases != NULL) return own->creases;
  return own != NULL && own->bare ? NULL : part->creases;
}

/* Is there sheet that could be creased: MLI, or what the scenario says is? */
static bool hangs(const struct um_scenario_part *part, const struct um_scenario_group *own)
{
  if (creases_of(part, own) != NULL || (own != NULL && own->mli != NULL)) return true;
  return part->mli != NULL && !(own != NULL && own->bare);
}

static enum um_status group_of(struct um_context *context, const struct um_model *model,
                               const struct um_geometry_group *group,
                               struct um_geometry_creasing *to)
{
  const struct um_scenario_part *part = part_of(model, group);
  const struct um_scenario_group *own = um_model_group_named(part, group->name);
  const struct um_scenario_creases *of_group = own != NULL ? own->flatness : NULL, *from;
  struct um_effect_use use;
  to->sheet = hangs(part, own);
  if (to->sheet && of_group != NULL)
    return um_model_fail(context, &own->at, "flatness",
                         "the group has MLI or creases; accepted: creases");
  from = to->sheet ? creases_of(part, own) : of_group != NULL ? of_group : part->flatness;
  if (from != NULL) {
    double tilt = from->tilt_rms_deg * UM_DEG;
    to->tilt_square = tilt * tilt;
    to->patch = from->patch_m;
    to->seed = (uint64_t)from->seed;
  }
  for (size_t i = 0; um_model_effect_next(model, &i, &use);) {
    const struct um_effect_hooks *h = &use.effect->hooks;
    if (to->sheet && h->creases != NULL)
      UM_TRY(h->creases(context, &use, part->name, group->name, to));
    if (!to->sheet && h->flatness != NULL)
      UM_TRY(h->flatness(context, &use, part->name, group->name, to));
  }
  return UM_OK;
}

/* Does a use act on any group that is built? */
static bool acts(const struct um_model *model, const struct um_effect_use *use)
{
  const struct um_geometry *g = model->geometry;
  const struct um_effect_hooks *h = &use->effect->hooks;
  for (size_t k = 0; k < um_geometry_group_count(g); k++) {
    const struct um_geometry_group *group = um_geometry_group(g, (uint32_t)k);
    if (um_effect_acts_on_group(use, um_geometry_part_name(g, group->part), group->name) &&
        (model->creasing[k].sheet ? h->creases != NULL : h->flatness != NULL))
      return true;
  }
  return false;
}

/* A use that would act on nothing is refused. */
static enum um_status check_uses(struct um_context *context, const struct um_model *model)
{
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);) {
    const struct um_effect_hooks *h = &use.effect->hooks;
    if ((h->creases == NULL && h->flatness == NULL) || acts(model, &use)) continue;
    return um_core_fail(context, UM_ERR_INPUT,
                        h->creases != NULL
                            ? "effect '%s': the part '%s' has no MLI; accepted: a part with MLI, "
                              "or one that states creases"
                            : "effect '%s': the part '%s' is MLI or creased; accepted: a part or "
                              "group that is neither",
                        use.effect->name, use.target);
  }
  return UM_OK;
}

/* The same of a part's key. */
static enum um_status check_parts(struct um_context *context, const struct um_model *model)
{
  const struct um_geometry *g = model->geometry;
  const struct um_scenario_part *part = model->scenario->parts.items;
  for (size_t p = 0; p < model->scenario->parts.count; p++) {
    bool any = part[p].flatness == NULL;
    for (size_t k = 0; !any && k < um_geometry_group_count(g); k++)
      any = um_geometry_group(g, (uint32_t)k)->part == p && !model->creasing[k].sheet;
    if (!any)
      return um_model_fail(context, &part[p].at, "flatness",
                           "all of the part is MLI or creased; accepted: creases");
  }
  return UM_OK;
}

enum um_status um_model_build_creases(struct um_context *context, struct um_model *model)
{
  size_t n = um_geometry_group_count(model->geometry);
  UM_TRY(um_core_allocate(context, n, sizeof *model->creasing, &model->creasing));
  for (size_t g = 0; g < n; g++)
    UM_TRY(group_of(context, model, um_geometry_group(model->geometry, (uint32_t)g),
                    &model->creasing[g]));
  UM_TRY(check_uses(context, model));
  UM_TRY(check_parts(context, model));
  enum um_status status = um_optics_creases_create(context, model->geometry, model->creasing,
                                                   model->material, &model->creases);
  return status == UM_OK ? status : um_model_blame_part(context, model, status);
}
