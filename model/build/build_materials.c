/* The material records of a model: those that the scenario names are read, and no others. */
#include <math.h>

#include "model/build/aging_group.h"
#include "model/build/effects_group.h"
#include "model/build/messages_group.h"
#include "model/build/steps_impl.h"

/* ---- every name of the scenario, with its line ---- */

/* name: NULL where the key is not there. */
typedef enum um_status (*um_material_seen)(struct um_context *context, struct um_model *model,
                                           const struct um_mark *at, const char *key,
                                           const char *name);

static enum um_status visit_shell(struct um_context *context, struct um_model *model,
                                  um_material_seen see, const struct um_scenario_shell *shell)
{
  if (shell == NULL) return UM_OK;
  UM_TRY(see(context, model, &shell->at, "material", shell->material));
  const struct um_scenario_layer *layer = shell->layers.items;
  for (size_t i = 0; i < shell->layers.count; i++)
    UM_TRY(see(context, model, &layer[i].at, "material", layer[i].material));
  if (shell->honeycomb == NULL) return UM_OK;
  const struct um_scenario_honeycomb *panel = shell->honeycomb;
  UM_TRY(see(context, model, &panel->at, "material", panel->material));
  return see(context, model, &panel->at, "core_material", panel->core_material);
}

static enum um_status visit_part(struct um_context *context, struct um_model *model,
                                 um_material_seen see, const struct um_scenario_part *part)
{
  const struct um_scenario_skin *skin = part->materials.items;
  const struct um_scenario_group *group = part->groups.items;
  UM_TRY(see(context, model, &part->at, "outside", part->outside));
  UM_TRY(see(context, model, &part->at, "front", part->front));
  UM_TRY(see(context, model, &part->at, "back", part->back));
  for (size_t i = 0; i < part->materials.count; i++) {
    UM_TRY(see(context, model, &skin[i].at, NULL, skin[i].front));
    UM_TRY(see(context, model, &skin[i].at, "back", skin[i].back));
  }
  UM_TRY(visit_shell(context, model, see, part->shell));
  if (part->solid != NULL)
    UM_TRY(see(context, model, &part->solid->at, "material", part->solid->material));
  for (size_t i = 0; i < part->groups.count; i++)
    UM_TRY(visit_shell(context, model, see, group[i].shell));
  return UM_OK;
}

static enum um_status visit(struct um_context *context, struct um_model *model,
                            um_material_seen see)
{
  const struct um_scenario_part *part = model->scenario->parts.items;
  for (size_t i = 0; i < model->scenario->parts.count; i++)
    UM_TRY(visit_part(context, model, see, &part[i]));
  return UM_OK;
}

/* ---- library ---- */

/* UM_ERR_INPUT without a message where it is not there yet. */
static enum um_status is_there(struct um_context *context, struct um_model *model,
                               const struct um_mark *at, const char *key, const char *name)
{
  (void)context;
  (void)at;
  (void)key;
  return name == NULL || um_materials_library_find(model->library, name) != NULL ? UM_OK
                                                                                 : UM_ERR_INPUT;
}

/* The material under a key comes into the library; the message names the nearest. */
static enum um_status want(struct um_context *context, struct um_model *model,
                           const struct um_mark *at, const char *key, const char *name)
{
  const struct um_materials_record *record;
  char near[1024];
  if (name == NULL) return UM_OK;
  UM_TRY(um_materials_library_want(context, model->library, name, &record));
  if (record != NULL) return UM_OK;
  um_materials_library_suggest(model->library, name, near, sizeof near);
  return um_model_fail(context, at, key, "no material is called '%s'; %s", name, near);
}

/* Records hang on the scenario and on the spectrum of the Sun alone: a variant borrows those of its
 * origin, unless it names others. */
static bool borrow_library(struct um_context *context, struct um_model *model,
                           const struct um_materials_sun *sun)
{
  static const char *const said[] = {"material_files", NULL};
  if (!um_model_origin_says(model, said) ||
      !um_materials_library_is_of(model->origin->library, sun))
    return false;
  model->library = model->origin->library;
  if (visit(context, model, is_there) == UM_OK) return true;
  model->library = NULL;
  return false;
}

enum um_status um_model_build_library(struct um_context *context, struct um_model *model)
{
  char *folder = NULL;
  struct um_materials_sun sun;
  um_environment_sun_shares(&model->environment, &sun);
  if (borrow_library(context, model, &sun)) return UM_OK;
  UM_TRY(um_materials_library_create(context, &sun, &model->library));
  UM_TRY(um_materials_library_folder(context, &folder));
  enum um_status status = um_materials_library_offer_folder(context, model->library, folder);
  um_core_free(context, folder);
  UM_TRY(status);
  const char *const *files = model->scenario->material_files.items;
  for (size_t i = 0; i < model->scenario->material_files.count; i++) {
    const char *path = NULL;
    UM_TRY(um_model_resolve(context, model, &model->scenario->at, files[i], &path));
    UM_TRY(um_model_blame(context, &model->scenario->at, "material_files",
                          um_materials_library_read_file(context, model->library, path, NULL, 0)));
  }
  return visit(context, model, want);
}

/* ---- records ---- */

/* Light in a band in which nothing was measured of a surface is a guess. */
static void warn_unmeasured(struct um_context *context, const struct um_model *model,
                            const struct um_materials_record *record)
{
  struct um_materials_measured_range m = um_materials_measured_range(record);
  for (size_t b = 0; b < model->nband && !isnan(m.from); b++) {
    const struct um_optics_band *band = &model->band[b];
    if (band->from >= m.from && band->to <= m.to) continue;
    um_core_log(context, UM_LOG_WARNING,
                "band %s, %.4g to %.4g um: material %s is measured from %.4g to %.4g um only",
                band->name, band->from * 1e6, band->to * 1e6, um_materials_name(record),
                m.from * 1e6, m.to * 1e6);
  }
}

enum um_status um_model_build_records(struct um_context *context, struct um_model *model)
{
  size_t n = um_geometry_material_count(model->geometry);
  UM_TRY(um_core_allocate(context, n, sizeof *model->material, &model->material));
  for (size_t i = 0; i < n; i++)
    model->material[i] =
        um_materials_library_find(model->library, um_geometry_material_name(model->geometry, i));
  for (size_t i = 0; i < n && model->origin == NULL; i++)
    warn_unmeasured(context, model, model->material[i]);
  UM_TRY(um_core_allocate(context, n, sizeof *model->adjustment, &model->adjustment));
  UM_TRY(um_model_materials_at(context, model, model->scenario->time->start, model->adjustment));
  UM_TRY(um_core_allocate(context, n, sizeof *model->thickened, &model->thickened));
  for (size_t i = 0; i < n; i++) { /* layers are as thick as at the start, all the time */
    double factor = model->adjustment[i].thickness_scale;
    if (factor == 1.0 || !um_materials_has_layers(model->material[i])) continue;
    UM_TRY(um_materials_library_thickened(context, model->library, model->material[i], factor,
                                          &model->thickened[i]));
    model->material[i] = model->thickened[i];
  }
  return UM_OK;
}
