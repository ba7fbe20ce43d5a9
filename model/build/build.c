/* Building a model: the order of the steps. */
#include "model/build/build.h"

#include "effects/effects.h"
#include "environment/map.h"
#include "environment/sky_table.h"
#include "model/build/effects_group.h"
#include "model/build/steps_impl.h"
#include "model/scenario/fail_group.h"
#include "model/scenario/scenario_read.h"

/* What hangs on the sky: parts, heat. */
static enum um_status build_body(struct um_context *context, struct um_model *model)
{
  UM_TRY(um_model_build_parts(context, model));
  UM_TRY(um_model_build_sky_light(context, model));
  UM_TRY(um_model_check_effects(context, model));
  UM_TRY(um_model_build_creases(context, model));
  UM_TRY(um_model_build_thermal(context, model));
  UM_TRY(um_model_build_blocked(context, model));
  return um_model_check_limits(context, model);
}

/* A model with its scenario read and its sky built. */
static enum um_status create_sky(struct um_context *context, const char *path,
                                 const struct um_model_options *options, struct um_model **out)
{
  enum um_status status;
  struct um_model *model = NULL;
  static const struct um_model_options plain;
  const struct um_model_options *read = options != NULL ? options : &plain;
  UM_TRY(um_core_allocate(context, 1, sizeof *model, &model));
  UM_CHECK(um_model_scenario_read(context, path, read->text, read->overrides, read->noverride,
                                  read->set, read->nset, &model->document, &model->scenario));
  UM_CHECK(um_orbit_ephemeris_create(context, &model->ephemeris));
  UM_CHECK(um_core_allocate(context, 1, sizeof *model->daylight, (void **)&model->daylight));
  UM_CHECK(um_model_build_effects(context, model, options));
  UM_CHECK(um_model_build_environment(context, model));
  UM_CHECK(um_model_build_orbit(context, model));
done:
  if (status != UM_OK) um_model_destroy(context, &model);
  *out = model;
  return status;
}

enum um_status um_model_create_orbit(struct um_context *context, const char *path,
                                     const struct um_model_options *options, struct um_model **out)
{
  return create_sky(context, path, options, out);
}

enum um_status um_model_create(struct um_context *context, const char *path,
                               const struct um_model_options *options, struct um_model **out)
{
  enum um_status status;
  struct um_model *model = NULL;
  *out = NULL;
  UM_TRY(create_sky(context, path, options, &model));
  UM_CHECK(build_body(context, model));
done:
  if (status != UM_OK) um_model_destroy(context, &model);
  *out = model;
  return status;
}

static enum um_status variant_make(struct um_context *context,
                                   const struct um_model_changes *changes, struct um_model *model)
{
  static const char *const code[] = {"effect_files", NULL};
  const struct um_model *origin = model->origin;
  if (changes->nkey > 0)
    UM_TRY(um_model_scenario_change(context, origin->document, changes->key, changes->nkey,
                                    &model->document, &model->scenario));
  if (!um_model_origin_says(model, code))
    return um_model_fail(context, &model->scenario->at, code[0],
                         "cannot change with the scenario; accepted: a scenario of its own");
  UM_TRY(um_model_vary_effects(context, model, changes));
  model->halvings = changes->halvings;
  UM_TRY(um_model_build_environment(context, model));
  UM_TRY(um_model_build_orbit(context, model));
  UM_TRY(build_body(context, model));
  for (size_t i = 0; i < changes->nsource; i++)
    UM_TRY(um_thermal_network_source_add(model->body->network, &changes->source[i]));
  if (changes->halvings != NULL) model->halvings = NULL; /* borrowed */
  return UM_OK;
}

enum um_status um_model_variant_create(struct um_context *context, const struct um_model *origin,
                                       const struct um_model_changes *changes,
                                       struct um_model **out)
{
  struct um_model *model = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *model, &model));
  model->origin = origin;
  model->document = origin->document;
  model->scenario = origin->scenario;
  model->registry = origin->registry;
  model->ephemeris = origin->ephemeris;
  model->daylight = origin->daylight;
  model->options = origin->options;
  enum um_status status = variant_make(context, changes, model);
  if (status != UM_OK) um_model_destroy(context, &model);
  *out = model;
  return status == UM_ERR_INPUT ? UM_ERR_REFUSED : status;
}

/* What a variant has the same belongs to its origin. */
static void destroy_owned(struct um_context *context, struct um_model *m)
{
  static const struct um_model nothing = {0};
  const struct um_model *of = m->origin != NULL ? m->origin : &nothing;
  if (m->library != of->library) um_materials_library_destroy(&m->library);
  if (m->earth_map != of->earth_map) um_environment_map_destroy(context, &m->earth_map);
  if (m->sky_table != of->sky_table) um_environment_sky_table_destroy(context, &m->sky_table);
  if (m->blocked != of->blocked) um_core_free(context, m->blocked);
  if (m->limb != of->limb) um_core_free(context, m->limb);
  if (m->umbra_scatter != of->umbra_scatter) um_core_free(context, m->umbra_scatter);
  if (m->daylight != of->daylight) UM_FREE(context, *m->daylight, m->daylight);
  if (m->sky_light != of->sky_light) um_core_free(context, m->sky_light);
  if (m->registry != of->registry) um_effects_registry_destroy(context, &m->registry);
  if (m->document != of->document) um_document_destroy(&m->document);
  if (m->ephemeris != of->ephemeris) um_orbit_ephemeris_destroy(context, &m->ephemeris);
}

void um_model_destroy(struct um_context *context, struct um_model **model)
{
  if (model == NULL || *model == NULL) return;
  struct um_model *m = *model;
  um_thermal_body_destroy(context, &m->body);
  if (m->thickened != NULL) /* before the library that they borrow from */
    for (size_t i = 0; i < um_geometry_material_count(m->geometry); i++)
      um_materials_record_destroy(&m->thickened[i]);
  um_core_free(context, m->thickened);
  um_geometry_destroy(&m->geometry);
  um_orbit_attitude_destroy(&m->attitude);
  um_orbit_trajectory_destroy(&m->trajectory);
  um_orbit_trajectory_destroy(&m->observer_trajectory);
  um_orbit_finals_destroy(&m->orientation.finals);
  UM_FREE(context, m->station, m->material, m->adjustment, m->effect);
  um_optics_creases_destroy(context, &m->creases);
  UM_FREE(context, m->creasing, m->start_offset);
  um_core_arena_release(context, &m->memory);
  destroy_owned(context, m);
  um_core_free(context, m);
  *model = NULL;
}
