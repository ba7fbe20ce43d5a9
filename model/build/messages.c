/* What the steps of building share: paths, messages with file and line of a part or table,
 * directions. */
#include "model/build/messages_group.h"

#include <stdio.h>
#include <string.h>

#include "base/core/file.h"

enum um_status um_model_resolve(struct um_context *context, struct um_model *model,
                                const struct um_mark *at, const char *relative, const char **out)
{
  char *path = NULL;
  (void)at;
  UM_TRY(um_core_path_resolve(context, model->scenario->at.file, relative, &path));
  size_t n = strlen(path) + 1;
  char *kept = NULL;
  enum um_status status = um_core_arena_allocate(context, &model->memory, n, 1, &kept);
  if (status == UM_OK) {
    memcpy(kept, path, n);
    *out = kept;
  }
  um_core_free(context, path);
  return status;
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

/* Does the recorded message begin with this and a character that ends a name? */
static bool message_begins(const struct um_context *context, const char *text)
{
  const char *message = um_core_message(context);
  size_t n = strlen(text);
  return strncmp(message, text, n) == 0 && strchr(":, '", message[n]) != NULL;
}

enum um_status um_model_blame_part(struct um_context *context, struct um_model *model,
                                   enum um_status status)
{
  if (status == UM_ERR_CANCELLED) return status;
  for (size_t i = 0; i < model->scenario->parts.count; i++) {
    const struct um_scenario_part *part =
        (const struct um_scenario_part *)model->scenario->parts.items + i;
    const char *path = NULL;
    char quoted[512], plain[512];
    snprintf(quoted, sizeof quoted, "part '%s'", part->name);
    snprintf(plain, sizeof plain, "part %s", part->name);
    if (message_begins(context, quoted) || message_begins(context, plain))
      return um_model_blame(context, &part->at, NULL, status);
    if (part->mesh == NULL) continue;
    UM_TRY(um_model_resolve(context, model, &part->mesh->at, part->mesh->file, &path));
    if (message_begins(context, path))
      return um_model_blame(context, &part->mesh->at, NULL, status);
  }
  um_core_message_prefix(context, "%s", model->scenario->at.file);
  return status;
}

/* Does the recorded message begin with the path of this file? The path ends as the scenario writes
 * the file. */
static bool names_file(const struct um_context *context, const char *file)
{
  const char *message = um_core_message(context);
  const char *at = file != NULL ? strstr(message, file) : NULL;
  return at != NULL && (at == message || at[-1] == '/') && at[strlen(file)] == ':';
}

enum um_status um_model_blame_table(struct um_context *context, const struct um_model *model,
                                    enum um_status status)
{
  const struct um_scenario *scenario = model->scenario;
  const struct um_scenario_attitude *law = scenario->attitude.items;
  const struct um_scenario_observer *observer = scenario->observer;
  if (status != UM_ERR_INPUT) return status;
  if (names_file(context, scenario->orbit->table))
    return um_model_blame(context, &scenario->orbit->at, "table", status);
  for (size_t i = 0; i < scenario->attitude.count; i++)
    if (law[i].table != NULL && names_file(context, law[i].table->file))
      return um_model_blame(context, &law[i].table->at, NULL, status);
  if (observer != NULL && observer->trajectory != NULL &&
      names_file(context, observer->trajectory->table))
    return um_model_blame(context, &observer->trajectory->at, "table", status);
  return status;
}
