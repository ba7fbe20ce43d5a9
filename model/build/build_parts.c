/* From the scenario's parts to geometry and material records. */
#include "model/build/steps_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/suggestions.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"

static const struct um_scenario_part *part_at(const struct um_model *model, size_t i)
{
  return (const struct um_scenario_part *)model->scenario->parts.items + i;
}

static void shape_of(const struct um_scenario_part *from, struct um_geometry_part_spec *to)
{
  const struct um_scenario_round *round = NULL;
  if (from->box != NULL) {
    to->shape = UM_SHAPE_BOX;
    memcpy(to->size, from->box->size_m, sizeof to->size);
  } else if (from->plate != NULL) {
    to->shape = UM_SHAPE_PLATE;
    memcpy(to->size, from->plate->size_m, sizeof from->plate->size_m);
  } else if (from->disc != NULL) {
    to->shape = UM_SHAPE_DISC;
    round = from->disc;
  } else if (from->cylinder != NULL) {
    to->shape = UM_SHAPE_CYLINDER;
    round = from->cylinder;
  } else if (from->cone != NULL) {
    to->shape = UM_SHAPE_CONE;
    round = from->cone;
  } else if (from->sphere != NULL) {
    to->shape = UM_SHAPE_SPHERE;
    round = from->sphere;
  } else if (from->paraboloid != NULL) {
    to->shape = UM_SHAPE_PARABOLOID;
    round = from->paraboloid;
  } else {
    to->shape = UM_SHAPE_MESH;
    to->mesh_scale = from->mesh->scale;
    to->mesh_groups = from->mesh->groups.items;
    to->nmesh_group = from->mesh->groups.count;
  }
  if (round != NULL) {
    to->radius = round->radius_m;
    to->radius_top = round->radius_top_m;
    to->height = round->height_m;
    to->focal_length = round->focal_length_m;
  }
}

/* z, then the new y, then the new x: R = Rx Ry Rz, passive. */
static struct um_quat rotation_of(const double deg[3])
{
  struct um_quat x = um_quat_from_axis(um_vec3(1, 0, 0), deg[0] * UM_DEG);
  struct um_quat y = um_quat_from_axis(um_vec3(0, 1, 0), deg[1] * UM_DEG);
  struct um_quat z = um_quat_from_axis(um_vec3(0, 0, 1), deg[2] * UM_DEG);
  return um_quat_then(um_quat_then(z, y), x);
}

static enum um_status schedule_of(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_joint *joint,
                                  struct um_geometry_part_spec *to)
{
  static const struct um_model_series_kind kind = {
      "schedule", "angle_deg", UM_DEG, "the first and the last angle hold outside of them"};
  struct um_model_series series;
  if (joint->schedule == NULL) return UM_OK;
  if (joint->track == 1)
    return um_model_fail(context, &joint->at, "schedule",
                         "stands beside track: sun; accepted: one of them");
  UM_TRY(um_model_series_read(context, model, &joint->at, joint->schedule, &kind, &series));
  to->joint = UM_JOINT_SCHEDULE;
  to->schedule = (struct um_geometry_schedule){series.nrow, series.t, series.value};
  return UM_OK;
}

static enum um_status place_of(struct um_context *context, struct um_model *model,
                               const struct um_scenario_part *from,
                               struct um_geometry_part_spec *to)
{
  to->parent = from->parent;
  to->rotation = (struct um_quat){1, 0, 0, 0};
  if (from->pose != NULL) {
    const double *p = from->pose->position_m;
    to->position = um_vec3(p[0], p[1], p[2]);
    to->rotation = rotation_of(from->pose->rotation_deg);
  }
  to->grain = um_vec3(from->grain[0], from->grain[1], from->grain[2]);
  if (from->joint == NULL) return UM_OK;
  to->joint = from->joint->track == 1 ? UM_JOINT_SUN : UM_JOINT_FIXED;
  to->joint_angle = from->joint->angle_deg * UM_DEG;
  UM_TRY(um_model_unit(context, &from->joint->at, "axis", from->joint->axis, &to->joint_axis));
  if (to->joint == UM_JOINT_SUN)
    UM_TRY(
        um_model_unit(context, &from->joint->at, "normal", from->joint->normal, &to->joint_normal));
  return schedule_of(context, model, from->joint, to);
}

/* outside/front/back become the skin of all groups; `materials` those of single groups. */
static enum um_status skins_of(struct um_context *context, struct um_model *model,
                               const struct um_scenario_part *from,
                               struct um_geometry_part_spec *to)
{
  const struct um_scenario_skin *single = from->materials.items;
  struct um_geometry_skin *skin = NULL;
  if (from->outside != NULL && (from->front != NULL || from->back != NULL))
    return um_model_fail(context, &from->at, "outside",
                         "is for closed parts, front and back are for open ones; accepted: one or "
                         "the other");
  UM_TRY(um_core_arena_allocate(context, &model->memory, from->materials.count + 1, sizeof *skin,
                                &skin));
  for (size_t i = 0; i < from->materials.count; i++)
    skin[to->nskin++] = (struct um_geometry_skin){single[i].name, single[i].front, single[i].back};
  const char *front = from->outside != NULL ? from->outside : from->front;
  if (front != NULL) skin[to->nskin++] = (struct um_geometry_skin){NULL, front, from->back};
  if (to->nskin == 0)
    return um_document_mark_fail(
        context, &from->at,
        "no material; accepted: outside, front and back, or materials by group");
  to->skins = skin;
  return UM_OK;
}

static enum um_status spec_of(struct um_context *context, struct um_model *model,
                              const struct um_scenario_part *from, struct um_geometry_part_spec *to)
{
  to->name = from->name;
  if (!um_model_name_is_plain(from->name))
    return um_model_fail(context, &from->at, "name",
                         "'%s' is not accepted; accepted: a word without . / : , ; quotes and "
                         "control characters",
                         from->name);
  shape_of(from, to);
  if (to->shape == UM_SHAPE_MESH)
    UM_TRY(um_model_resolve(context, model, &from->mesh->at, from->mesh->file, &to->mesh_path));
  UM_TRY(place_of(context, model, from, to));
  UM_TRY(skins_of(context, model, from, to));
  double size =
      isnan(from->facet_size_m) ? model->scenario->thermal->facet_size_m : from->facet_size_m;
  to->facet_size = isnan(size) ? 0.0 : size;
  to->solid = from->solid != NULL || um_model_interior_is_solid(from);
  struct um_effect_use use;
  for (size_t i = 0; um_model_effect_next(model, &i, &use);)
    if (use.effect->hooks.geometry != NULL) UM_TRY(use.effect->hooks.geometry(context, &use, to));
  return UM_OK;
}

static enum um_status check_parent(struct um_context *context, const struct um_model *model,
                                   const struct um_scenario_part *part)
{
  char names[512] = "", hint[UM_CORE_WORDS_HINT];
  if (part->parent == NULL) return UM_OK;
  struct um_core_words_guess guess = {.written = part->parent};
  for (size_t i = 0; i < model->scenario->parts.count; i++) {
    if (strcmp(part_at(model, i)->name, part->parent) == 0) return UM_OK;
    if (part_at(model, i) == part) continue;
    um_core_words_append(names, sizeof names, part_at(model, i)->name);
    um_core_words_consider(&guess, part_at(model, i)->name);
  }
  return um_model_fail(context, &part->at, "parent", "'%s' is not a part%s; accepted: %s",
                       part->parent, um_core_words_hint(&guess, hint),
                       names[0] == '\0' ? "none, there is no other part" : names);
}

enum um_status um_model_build_parts(struct um_context *context, struct um_model *model)
{
  size_t n = model->scenario->parts.count;
  enum um_status status;
  struct um_geometry_part_spec *specs = NULL;
  if (n == 0)
    return um_model_fail(context, &model->scenario->at, "parts",
                         "is empty; accepted: one part or more");
  UM_TRY(um_model_build_library(context, model));
  UM_TRY(um_model_build_bands(context, model));
  UM_TRY(um_core_allocate(context, n, sizeof *specs, &specs));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(spec_of(context, model, part_at(model, i), &specs[i]));
    UM_CHECK(check_parent(context, model, part_at(model, i)));
  }
  if (model->halvings == NULL) UM_CHECK(um_model_build_facets(context, model));
  for (size_t i = 0; i < n && model->halvings != NULL; i++) specs[i].halvings = model->halvings[i];
  status = um_geometry_create(context, specs, n, &model->geometry);
  if (status != UM_OK) {
    status = um_model_blame_part(context, model, status);
    goto done;
  }
  UM_CHECK(um_model_build_records(context, model));
  /* a variant has the parts of its origin, which said it */
  if (model->origin == NULL) UM_CHECK(um_model_warn_coincident(context, model));
done:
  um_core_free(context, specs);
  return status;
}
