/* From the scenario's parts to geometry and material records. */
#include <math.h>
#include <string.h>

#include "core/constants.h"
#include "model/model_impl.h"

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

static enum um_status place_of(struct um_context *context, const struct um_scenario_part *from,
                               struct um_geometry_part_spec *to)
{
  to->parent = from->parent;
  to->rotation = (struct um_quat){1, 0, 0, 0};
  if (from->pose != NULL) {
    const double *p = from->pose->position_m;
    to->position = um_vec3(p[0], p[1], p[2]);
    to->rotation = rotation_of(from->pose->rotation_deg);
  }
  if (from->joint == NULL) return UM_OK;
  to->joint = from->joint->track == 1 ? UM_JOINT_SUN : UM_JOINT_FIXED;
  to->joint_angle = from->joint->angle_deg * UM_DEG;
  UM_TRY(um_model_unit(context, &from->joint->at, "axis", from->joint->axis, &to->joint_axis));
  if (to->joint == UM_JOINT_SUN)
    UM_TRY(
        um_model_unit(context, &from->joint->at, "normal", from->joint->normal, &to->joint_normal));
  return UM_OK;
}

/* outside/front/back become the skin of all groups; `materials` those of single groups. */
static enum um_status skins_of(struct um_context *context, struct um_model *model,
                               const struct um_scenario_part *from,
                               struct um_geometry_part_spec *to)
{
  const struct um_scenario_skin *single = from->materials.items;
  struct um_geometry_skin *skin = NULL;
  if (from->outside != NULL && (from->front != NULL || from->back != NULL))
    return um_core_mark_fail(context, &from->at,
                             "outside is for closed parts, front and back are for open ones; "
                             "give one or the other");
  UM_TRY(um_core_document_allocate(context, model->document, from->materials.count + 1,
                                   sizeof *skin, &skin));
  for (size_t i = 0; i < from->materials.count; i++)
    skin[to->nskin++] = (struct um_geometry_skin){single[i].name, single[i].front, single[i].back};
  const char *front = from->outside != NULL ? from->outside : from->front;
  if (front != NULL) skin[to->nskin++] = (struct um_geometry_skin){NULL, front, from->back};
  if (to->nskin == 0)
    return um_core_mark_fail(
        context, &from->at,
        "no material; accepted: outside, front and back, or materials by group");
  to->skins = skin;
  return UM_OK;
}

static enum um_status spec_of(struct um_context *context, struct um_model *model,
                              const struct um_scenario_part *from, struct um_geometry_part_spec *to)
{
  to->name = from->name;
  if (from->name[0] == '\0' || strpbrk(from->name, "./:,") != NULL)
    return um_core_mark_fail(context, &from->at, "name '%s' must not be empty nor hold . / : or ,",
                             from->name);
  shape_of(from, to);
  if (to->shape == UM_SHAPE_MESH)
    UM_TRY(um_model_resolve(context, model, &from->mesh->at, from->mesh->file, &to->mesh_path));
  UM_TRY(place_of(context, from, to));
  UM_TRY(skins_of(context, model, from, to));
  double size =
      isnan(from->facet_size_m) ? model->scenario->thermal->facet_size_m : from->facet_size_m;
  to->facet_size = isnan(size) ? 0.0 : size;
  to->solid = from->solid != NULL;
  return UM_OK;
}

/* Every name in a scenario is checked with its line before the geometry is built. */
static enum um_status check_materials(struct um_context *context, const struct um_model *model,
                                      const struct um_scenario_part *part,
                                      const struct um_geometry_part_spec *spec)
{
  for (size_t i = 0; i < spec->nskin; i++) {
    const char *names[2] = {spec->skins[i].front, spec->skins[i].back};
    for (int k = 0; k < 2; k++) {
      char near[256];
      if (names[k] == NULL || um_materials_library_find(model->library, names[k]) != NULL) continue;
      um_materials_library_suggest(model->library, names[k], near, sizeof near);
      return um_core_mark_fail(context, &part->at, "no material is called '%s'; %s", names[k],
                               near);
    }
  }
  return UM_OK;
}

static enum um_status build_library(struct um_context *context, struct um_model *model)
{
  char *folder = NULL;
  UM_TRY(um_materials_library_create(context, &model->library));
  UM_TRY(um_materials_library_folder(context, &folder));
  enum um_status status = um_materials_library_read_folder(context, model->library, folder);
  um_core_free(context, folder);
  UM_TRY(status);
  const char *const *files = model->scenario->material_files.items;
  for (size_t i = 0; i < model->scenario->material_files.count; i++) {
    const char *path = NULL;
    UM_TRY(um_model_resolve(context, model, &model->scenario->at, files[i], &path));
    UM_TRY(um_materials_library_read_file(context, model->library, path, NULL, 0));
  }
  return UM_OK;
}

static enum um_status build_records(struct um_context *context, struct um_model *model)
{
  size_t n = um_geometry_material_count(model->geometry);
  UM_TRY(um_core_allocate(context, n, sizeof *model->material, &model->material));
  for (size_t i = 0; i < n; i++)
    model->material[i] =
        um_materials_library_find(model->library, um_geometry_material_name(model->geometry, i));
  return UM_OK;
}

static enum um_status build_bands(struct um_context *context, struct um_model *model)
{
  static const struct um_optics_band standard[2] = {{"vis", 0.38e-6, 0.78e-6, 80},
                                                    {"lwir", 8e-6, 12e-6, 40}};
  const struct um_schema_list *list = &model->scenario->bands;
  const struct um_scenario_band *from = list->items;
  model->nband = list->count > 0 ? list->count : 2;
  UM_TRY(um_core_allocate(context, model->nband, sizeof *model->band, &model->band));
  if (list->count == 0) {
    memcpy(model->band, standard, sizeof standard);
    return UM_OK;
  }
  for (size_t i = 0; i < list->count; i++) {
    if (!(from[i].from_um < from[i].to_um))
      return um_core_mark_fail(context, &from[i].at, "from_um %g must be less than to_um %g",
                               from[i].from_um, from[i].to_um);
    model->band[i] = (struct um_optics_band){from[i].name, from[i].from_um * 1e-6,
                                             from[i].to_um * 1e-6, from[i].bins};
  }
  return UM_OK;
}

enum um_status um_model_build_parts(struct um_context *context, struct um_model *model)
{
  size_t n = model->scenario->parts.count;
  enum um_status status;
  struct um_geometry_part_spec *specs = NULL;
  if (n == 0)
    return um_core_mark_fail(context, &model->scenario->at, "parts is empty; one part is needed");
  UM_TRY(build_library(context, model));
  UM_TRY(build_bands(context, model));
  UM_TRY(um_core_allocate(context, n, sizeof *specs, &specs));
  for (size_t i = 0; i < n; i++) {
    UM_CHECK(spec_of(context, model, part_at(model, i), &specs[i]));
    UM_CHECK(check_materials(context, model, part_at(model, i), &specs[i]));
  }
  status = um_geometry_create(context, specs, n, &model->geometry);
  if (status != UM_OK) {
    um_core_message_prefix(context, "%s", model->scenario->at.file);
    goto done;
  }
  UM_CHECK(build_records(context, model));
done:
  um_core_free(context, specs);
  return status;
}
