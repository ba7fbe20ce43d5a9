/* Models, and the names of what they have. */
#include "library/model_impl.h"

#include "library/scenario_impl.h"
#include "model/build/build.h"

static size_t count_of(const struct um_model *model, enum umbra_names kind)
{
  size_t materials = um_geometry_material_count(model->geometry);
  switch (kind) {
  case UMBRA_PARTS:
    return um_geometry_part_count(model->geometry);
  case UMBRA_PLACES:
    return model->body->nplace + materials;
  case UMBRA_MATERIALS:
    return materials;
  case UMBRA_BANDS:
    return model->nband;
  case UMBRA_SENSORS:
    return model->nsensor;
  case UMBRA_MECHANISMS:
    return UM_MECHANISM_COUNT;
  }
  return 0;
}

static const char *name_of(const struct umbra_model *model, enum umbra_names kind, size_t i)
{
  const struct um_model *m = model->model;
  switch (kind) {
  case UMBRA_PARTS:
    return um_geometry_part_name(m->geometry, i);
  case UMBRA_PLACES:
    return i < m->body->nplace ? m->body->place[i].name
                               : model->material_place[i - m->body->nplace];
  case UMBRA_MATERIALS:
    return um_geometry_material_name(m->geometry, i);
  case UMBRA_BANDS:
    return m->band[i].name;
  case UMBRA_SENSORS:
    return m->sensor[i].name;
  case UMBRA_MECHANISMS:
    return um_optics_mechanism_name((enum um_optics_mechanism)i);
  }
  return NULL;
}

static enum um_status list_names(struct um_context *context, struct umbra_model *model)
{
  const struct um_geometry *geometry = model->model->geometry;
  size_t materials = um_geometry_material_count(geometry);
  UM_TRY(um_core_allocate(context, materials, sizeof(char *), &model->material_place));
  for (size_t i = 0; i < materials; i++)
    UM_TRY(um_core_asprintf(context, &model->material_place[i], "material:%s",
                            um_geometry_material_name(geometry, i)));
  for (int kind = 0; kind < UM_LIBRARY_NAMES; kind++) {
    model->count[kind] = count_of(model->model, (enum umbra_names)kind);
    UM_TRY(um_core_allocate(context, model->count[kind], sizeof(char *), &model->name[kind]));
    for (size_t i = 0; i < model->count[kind]; i++)
      model->name[kind][i] = name_of(model, (enum umbra_names)kind, i);
  }
  return UM_OK;
}

enum umbra_status umbra_model_build(struct umbra *umbra, const struct umbra_scenario *scenario,
                                    struct umbra_model **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct umbra_model *model = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *model, &model));
  atomic_init(&model->users, 1);
  model->session = um_library_session_share(umbra);
  UM_CHECK(um_library_source_copy(context, &scenario->source, &model->source));
  model->options = um_library_source_options(&model->source, umbra);
  UM_CHECK(um_model_create(context, model->source.path, &model->options, &model->model));
  UM_CHECK(um_core_strdup(context, um_core_log_text(context), &model->log));
  UM_CHECK(list_names(context, model));
  *out = model;
done:
  if (status != UM_OK) um_library_model_drop(&model);
  return um_library_status(status);
}

struct umbra_model *um_library_model_share(struct umbra_model *model)
{
  atomic_fetch_add(&model->users, 1);
  return model;
}

void um_library_model_drop(struct umbra_model **model)
{
  if (model == NULL || *model == NULL) return;
  struct umbra_model *m = *model;
  *model = NULL;
  if (atomic_fetch_sub(&m->users, 1) != 1) return;
  struct umbra *session = m->session;
  struct um_context *context = session->context;
  size_t materials = m->material_place != NULL ? um_geometry_material_count(m->model->geometry) : 0;
  for (size_t i = 0; i < materials; i++) um_core_free(context, m->material_place[i]);
  um_core_free(context, m->material_place);
  for (int kind = 0; kind < UM_LIBRARY_NAMES; kind++) um_core_free(context, (void *)m->name[kind]);
  um_model_destroy(context, &m->model);
  um_core_free(context, m->log);
  um_library_source_release(context, &m->source);
  um_core_free(context, m);
  um_library_session_drop(&session);
}

void umbra_model_close(struct umbra_model **model) { um_library_model_drop(model); }

enum umbra_status umbra_model_names(struct umbra *umbra, const struct umbra_model *model,
                                    enum umbra_names kind, const char *const **out, size_t *count)
{
  struct um_context *context = um_library_begin(umbra);
  *out = NULL;
  *count = 0;
  if ((int)kind < 0 || (int)kind >= UM_LIBRARY_NAMES)
    return um_library_status(um_core_fail(context, UM_ERR_INPUT,
                                          "no kind of names %d; accepted: 0 to %d", (int)kind,
                                          UM_LIBRARY_NAMES - 1));
  *out = model->name[kind];
  *count = model->count[kind];
  return UMBRA_OK;
}
