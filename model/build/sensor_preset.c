/* Sensors that come with the program, and a scenario's sensor on top of one. */
#include "model/build/sensor_preset.h"

#include <string.h>

#include "base/core/data.h"
#include "base/core/file.h"
#include "base/document/schema.h"
#include "model/scenario/fail_group.h"
#include "model/scenario/scenario.h"
#include "model/scenario/scenario_schema_group.h"

#define TAIL ".yaml"

enum um_status um_model_sensor_presets(struct um_context *context, char ***names, size_t *count)
{
  return um_core_data_names(context, "sensors", TAIL, names, count);
}

enum um_status um_model_sensor_preset_path(struct um_context *context, const char *name, char **out)
{
  return um_core_data_find(context, "sensor", "sensors", TAIL, name, out);
}

enum um_status um_model_sensor_preset_read(struct um_context *context, const char *path,
                                           struct um_document **document,
                                           struct um_scenario_preset **out)
{
  void *root = NULL;
  *out = NULL;
  UM_TRY(um_document_read(context, path, &um_model_preset_schema, NULL, 0, document, &root));
  *out = root;
  return UM_OK;
}

static bool states(const struct um_scenario_sensor *sensor, const char *key)
{
  return um_document_mark_key(&sensor->at, key) != &sensor->at;
}

/* A detector's efficiency is one number or one curve: who states either has both. */
static bool states_either(const struct um_scenario_sensor *sensor, const char *key)
{
  if (strncmp(key, "quantum_efficiency", strlen("quantum_efficiency")) != 0)
    return states(sensor, key);
  return states(sensor, "quantum_efficiency") || states(sensor, "quantum_efficiency_file");
}

/* A name of a file beside the preset, for the model to keep. */
static enum um_status take_file(struct um_context *context, struct um_model *model,
                                const char *path, const char *name, const char **out)
{
  char *whole, *kept;
  UM_TRY(um_core_path_resolve(context, path, name, &whole));
  enum um_status status =
      um_core_arena_allocate(context, &model->memory, strlen(whole) + 1, 1, &kept);
  if (status == UM_OK) *out = strcpy(kept, whole);
  um_core_free(context, whole);
  return status;
}

enum um_status um_model_sensor_preset(struct um_context *context, struct um_model *model,
                                      const struct um_scenario_sensor *stated,
                                      struct um_scenario_sensor *out)
{
  enum um_status status;
  struct um_document *document = NULL;
  struct um_scenario_preset *preset;
  char *path = NULL;
  *out = *stated;
  if (stated->preset == NULL) return UM_OK;
  UM_CHECK(um_model_blame(context, &stated->at, "preset",
                          um_model_sensor_preset_path(context, stated->preset, &path)));
  UM_CHECK(um_model_sensor_preset_read(context, path, &document, &preset));
  const struct um_schema_object *keys = &um_model_preset_sensor_schema;
  for (size_t i = 0; i < keys->nfield; i++) {
    const struct um_schema_field *field = &keys->fields[i];
    const char *from = (const char *)preset->sensor + field->offset;
    char *to = (char *)out + field->offset;
    if (states_either(stated, field->key)) continue;
    if (field->type == UM_SCHEMA_NUMBER) {
      memcpy(to, from, sizeof(double));
      continue;
    }
    const char *name, *kept = NULL;
    memcpy(&name, from, sizeof name);
    if (name != NULL) UM_CHECK(take_file(context, model, path, name, &kept));
    memcpy(to, &kept, sizeof kept);
  }
done:
  um_document_destroy(&document);
  um_core_free(context, path);
  return status;
}
