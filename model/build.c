/* Building a model: the order of the steps, and what they share. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/file.h"
#include "model/model_impl.h"

enum um_status um_model_resolve(struct um_context *context, struct um_model *model,
                                const struct um_mark *at, const char *relative, const char **out)
{
  char *path = NULL;
  (void)at;
  UM_TRY(um_core_path_resolve(context, model->scenario->at.file, relative, &path));
  size_t n = strlen(path) + 1;
  char *kept = NULL;
  enum um_status status = um_core_document_allocate(context, model->document, n, 1, &kept);
  if (status == UM_OK) {
    memcpy(kept, path, n);
    *out = kept;
  }
  um_core_free(context, path);
  return status;
}

enum um_status um_model_blame(struct um_context *context, const struct um_mark *at, const char *key,
                              enum um_status status)
{
  if (status == UM_OK || status == UM_ERR_MEMORY) return status;
  const char *dot = at->path[0] != '\0' && key != NULL ? "." : "";
  if (key == NULL) key = "";
  if (at->path[0] != '\0' || key[0] != '\0')
    um_core_message_prefix(context, "%s%s%s", at->path, dot, key);
  if (at->line > 0)
    um_core_message_prefix(context, "%s:%d", at->file, at->line);
  else
    um_core_message_prefix(context, "%s", at->file);
  return status;
}

enum um_status um_model_fail(struct um_context *context, const struct um_mark *at, const char *key,
                             const char *format, ...)
{
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return um_model_blame(context, at, key, um_core_fail(context, UM_ERR_INPUT, "%s", text));
}

bool um_model_name_is_plain(const char *name)
{
  for (const char *c = name; *c != '\0'; c++)
    if ((unsigned char)*c < 0x20 || *c == 0x7f || strchr("./:,;'\"\\", *c) != NULL) return false;
  return name[0] != '\0';
}

enum um_status um_model_unit(struct um_context *context, const struct um_mark *at, const char *key,
                             const double v[3], struct um_vec3 *out)
{
  struct um_vec3 u = um_vec3(v[0], v[1], v[2]);
  double norm = um_vec3_norm(u);
  if (!(norm > 0.0))
    return um_model_fail(context, at, key, "is the zero vector; accepted: a direction");
  *out = um_vec3_scale(u, 1.0 / norm);
  return UM_OK;
}

/* A model with its scenario read and its sky built. */
static enum um_status create_sky(struct um_context *context, const char *path,
                                 const struct um_model_options *options, struct um_model **out)
{
  enum um_status status;
  struct um_model *model = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *model, &model));
  UM_CHECK(um_model_scenario_read(context, path, options == NULL ? NULL : options->overrides,
                                  options == NULL ? 0 : options->noverride, &model->document,
                                  &model->scenario));
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
  UM_CHECK(um_model_build_parts(context, model));
  UM_CHECK(um_model_build_thermal(context, model));
done:
  if (status != UM_OK) um_model_destroy(context, &model);
  *out = model;
  return status;
}

void um_model_destroy(struct um_context *context, struct um_model **model)
{
  if (model == NULL || *model == NULL) return;
  struct um_model *m = *model;
  um_thermal_body_destroy(context, &m->body);
  um_geometry_destroy(&m->geometry);
  um_materials_library_destroy(&m->library);
  um_orbit_attitude_destroy(&m->attitude);
  um_orbit_trajectory_destroy(&m->trajectory);
  um_orbit_trajectory_destroy(&m->observer_trajectory);
  um_orbit_finals_destroy(&m->orientation.finals);
  um_core_free(context, m->material);
  um_core_free(context, m->adjustment);
  um_core_free(context, m->effect);
  um_core_free(context, m->band);
  um_core_document_destroy(&m->document);
  um_core_free(context, m);
  *model = NULL;
}
